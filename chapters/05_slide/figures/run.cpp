#include <algorithm>

#include "figures.hpp"
#include "first_contact/mesh_io/read_mesh.hpp"
#include "parts.hpp"
#include "places.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

namespace {

// A closed surface whose faces look outwards shows only those that face the eye.
bool closed_outwards(const Environment& environment) {
  const auto& edges = environment.topology().edges();
  double volume = 0;
  for (std::size_t i = 0; i < environment.mesh().size(); ++i) {
    const Triangle triangle = environment.mesh().triangle(i);
    volume += triangle.a.dot(triangle.b.cross(triangle.c));
  }
  return volume > 0 &&
         std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.side_count == 2; });
}

}  // namespace

void draw_bunny(const Studio& studio) {
  const Environment bunny(read_mesh(places::meshes + std::string("/bunny.off")));
  const auto& [ball, wish] = over_the_bunny;
  const Frames run = slide_frames(over_the_bunny, bunny, 150);
  figure::Scene scene({72, 24}, 0.03);
  scene.mesh(bunny.mesh(), {colour::floor, 1, true}, true, -1);
  scene.sphere(ball);
  scene.arrow(ball.center, ball.center + 16 * wish, {colour::red, 2.4}, 3);
  for (const std::size_t frame : {86U, 150U})
    scene.sphere({run.positions[frame], ball.radius}, colour::amber, 0.6, 1);
  scene.line(run.positions, {colour::green, 2.4}, 2);
  Figure figure(studio, "bunny", scene.size());
  scene.draw(figure);
  figure.draw();
}

void draw_run(const Studio& studio, const Environment& environment, const Moving<Sphere>& ball,
              const Slide& path) {
  figure::Scene scene({70, 24}, 0.04);
  Fill fill{colour::floor, 1, environment.mesh().size() > 2};  // a lone wall needs no light
  if (environment.mesh().size() <= 200) fill.outline = wall_edge;
  scene.mesh(environment.mesh(), fill, closed_outwards(environment), -1);
  scene.sphere(ball.shape);
  if (path.positions.size() > 1) scene.sphere({path.end(), ball.shape.radius}, colour::amber, 0.6, 1);
  for (std::size_t i = 1; i < path.positions.size(); ++i)
    scene.arrow(path.positions[i - 1], path.positions[i], i == 1 ? Pen{colour::red, 2.4} : way, 2);
  for (const Point& position : path.positions) scene.dot(position);
  for (const Contact& contact : path.contacts) scene.dot(contact.point(), colour::blue);
  Figure figure(studio, "slide", scene.size());
  scene.draw(figure);
  figure.draw();
}
