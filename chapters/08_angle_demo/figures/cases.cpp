#include "figures.hpp"
#include "parts.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;
using Eigen::Vector2d;

namespace {

// One of the four cases by itself: velocities before and after. The distance is not to scale.
void add_case(figure::Scene& scene, const Vector2d& origin, const Vector2d& between, double scale,
              const Encounter& encounter) {
  constexpr double size = 0.34;
  const Outcome printed = as_printed(encounter), corrected = at_contact(encounter);
  const Colour& after = printed.collides == corrected.collides ? colour::green : colour::pink;
  const std::array<Vector2d, 2> at{origin, origin + between}, before{encounter.v1, encounter.v2};
  scene.line({flat(at[0]), flat(at[1])}, {colour::grey, 1.2, true}, -1);
  for (const std::size_t i : {0U, 1U}) {
    add_disc(scene, at[i], size, body[i], 1);
    const std::string mass = "{/:Italic m} = " + program::readable(encounter.mass[static_cast<int>(i)]);
    if (between.x() > 1)
      scene.label(mass, flat(at[i]), 0, -1.5);
    else  // one above the other
      scene.label(mass, flat(at[i]), i ? 1.8 : 0, i ? 0 : 1.5, colour::ink, i ? Align::left : Align::centre);
    if (printed.collides) add_velocity(scene, at[i], size, scale * before[i], colour::red);
    add_velocity(scene, at[i], size, scale * printed.velocity[i], after, {angle_text(printed.angle[i]), 1.2});
  }
}

}  // namespace

void draw_cases(const program::Program& program) {
  const auto cases = paper_cases();
  figure::Scene scene(above, 0.02);
  const Vector2d aside(3, 0);
  add_case(scene, {0, 4.2}, aside, 1.1, cases[0]);
  add_case(scene, {10.2, 4.2}, aside, 1.1, cases[1]);
  add_case(scene, {0, -0.6}, aside, 1.1, cases[2]);
  add_case(scene, {10.8, 0.5}, {0.08, -1.6}, 0.6, cases[3]);
  const std::string before = program.say({"before", "碰撞前"});
  const std::string after = program.say({"after", "碰撞後"});
  const std::string as_printed = program.say({"as printed;", "論文原式；"});
  const std::string apart = program.say({"they never meet", "其實並未相碰"});
  scene.label(before, {1.5, 4.6, 0}, 0, 0, colour::red);
  scene.label(after, {5, 4.6, 0}, 0, 0, colour::green, Align::left);
  scene.label(as_printed, {12.1, -1.9, 0}, 0, 0, colour::pink, Align::left);
  scene.label(apart, {12.1, -2.5, 0}, 0, 0, colour::pink, Align::left);
  for (int i = 0; i < 4; ++i) {
    const std::string number = std::to_string(i + 1);
    scene.label(program.say({"Case " + number, "狀況" + number}), {i % 2 ? 8.1 : -1.2, i < 2 ? 6.7 : 2.1, 0},
                0, 0, colour::ink, Align::left);
  }
  scene.label("", {16.2, 7, 0});
  scene.label("", {-1.4, -4, 0});
  Figure figure(program.studio(), "cases", scene.size(960));
  scene.draw(figure);
  figure.draw();
}
