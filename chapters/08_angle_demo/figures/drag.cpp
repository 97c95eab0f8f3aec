#include "figures.hpp"
#include "parts.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;
using Eigen::Vector2d;

void draw_drag(const program::Program& program) {
  const Encounter soft = soft_and_aslant();
  const Outcome wrong = as_printed(soft), truth = at_contact(soft);
  const auto at = centres(soft, 0);
  const std::array<Vector2d, 2> before{soft.v1, soft.v2};
  const double scale = 1.7;
  figure::Scene scene(above, 0.03);
  scene.line({{-4, 0, 0}, {4, 0, 0}}, {colour::grey, 1.2, true}, -1);
  scene.line({{0, -1.6, 0}, {0, 1.6, 0}}, {colour::grey, 1.2, true}, -1);
  for (const std::size_t i : {0U, 1U}) {
    add_disc(scene, at[i], 1, body[i], 0.55);
    scene.arrow(flat(at[i]), flat(at[i] + scale * before[i]), {colour::red, 2.4}, 3);
    scene.arrow(flat(at[i]), flat(at[i] + scale * wrong.velocity[i]), {colour::pink, 2.4}, 3);
    scene.arrow(flat(at[i]), flat(at[i] + scale * truth.velocity[i]), {colour::green, 2.4}, 3);
    scene.dot(flat(at[i]));
  }
  scene.label(program.say({"before", "碰撞前"}), flat(at[0] + scale * before[0]), 0.6, 0.3, colour::red,
              Align::left);
  scene.label(program.say({"as printed", "論文原式"}), flat(at[0] + scale * wrong.velocity[0]), -0.6, 0,
              colour::pink, Align::right);
  scene.label(program.say({"corrected", "修正"}), flat(at[0] + scale * truth.velocity[0]), -0.6, 0.3,
              colour::green, Align::right);
  Figure figure(program.studio(), "drag", scene.size());
  scene.draw(figure);
  figure.draw();
}
