#include <array>
#include <cmath>
#include <numbers>

#include "figures.hpp"
#include "first_contact/mesh_io/read_mesh.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "parts.hpp"
#include "places.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

namespace {

constexpr double pi = std::numbers::pi;

Colour colour_of(Feature feature) {
  return feature == Feature::face ? colour::amber : feature == Feature::edge ? colour::green : colour::pink;
}

}  // namespace

void draw_bunny(const program::Program& program) {
  const Environment bunny{read_mesh(std::string(places::meshes) + "/bunny.off")};
  Eigen::AlignedBox3d bounds;
  for (const Point& p : bunny.mesh().vertices()) bounds.extend(p);
  const double size = bounds.sizes().maxCoeff();
  const View view{74, 20};
  figure::Scene scene(view);
  scene.mesh(bunny.mesh(), {colour::sky, 1, true}, true);
  for (int i = 0; i < 12; ++i) {
    const double turn = (view.turn - 175 + 170.0 * i / 11) * pi / 180;
    const Vector out(std::cos(turn), std::sin(turn), 0.15 + 0.55 * std::cos(2.4 * i));
    const Point from = bounds.center() + 0.95 * size * out;
    const Moving<Sphere> ball{{from, 0.035 * size}, bounds.center() - from};
    const auto contact = sweep(ball, bunny);
    if (!contact) continue;
    const Point touching = from + contact->time * ball.displacement;
    scene.arrow(touching + 0.3 * size * out.normalized(), touching, {colour::red, 1.4}, 1);
    scene.sphere({touching, ball.shape.radius}, colour_of(contact->feature), 1, 2, 9);
  }
  const Point legend = bounds.center() - 0.62 * size * view.up() - 0.52 * size * view.right();
  const std::array<std::pair<Feature, program::Text>, 3> names{{{Feature::face, {"face", "面"}},
                                                                {Feature::edge, {"edge", "稜"}},
                                                                {Feature::vertex, {"vertex", "頂點"}}}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Point place = legend + 0.38 * size * static_cast<double>(i) * view.right();
    scene.sphere({place, 0.035 * size}, colour_of(names[i].first), 1, 2, 9);
    scene.label(program.say(names[i].second), place, 2.4, 0, colour::ink, Align::left);
  }
  finish(program.studio(), "bunny", scene);
}
