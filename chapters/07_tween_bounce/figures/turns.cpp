#include <cmath>
#include <numbers>

#include "figures.hpp"
#include "first_contact/figure/scene.hpp"

using namespace first_contact;
using namespace first_contact::figure;
using program::Program;
namespace colour = first_contact::figure::colour;

namespace tween_bounce {

namespace {

constexpr double degree = std::numbers::pi / 180;

// Half a turn in five pictures: by its sixteen numbers, and by its angle.
void draw_sixteen_numbers(const Program& program) {
  Scene scene(View{60, 20}, 0.02);
  const View& view = View{60, 20};
  for (int row = 0; row < 2; ++row)
    for (int i = 0; i <= 4; ++i) {
      const double s = i / 4.0, angle = row == 0 ? 0 : 180 * s * degree, size = row == 0 ? 1 - 2 * s : 1;
      const Point middle = 2.5 * i * view.right() - 2.7 * row * view.up();
      const Vector r = 1.7 * size * Vector(std::cos(angle), std::sin(angle), 0);
      const Vector t = 0.9 * size * Vector(-std::sin(angle), std::cos(angle), 0);
      scene.box(Box(middle, r, t, {0, 0, 1}), {row == 0 ? colour::pink : colour::amber, 1, true});
      if (size == 0)
        scene.line({middle - Vector(0, 0, 0.5), middle + Vector(0, 0, 0.5)}, {colour::pink, 2.4});
      // a corner that one can follow
      scene.dot(middle + (r - t) / 2 + Vector(0, 0, 0.5), colour::ink);
      if (row == 1)
        scene.label((i == 0 ? "{/:Italic s} = " : "") + program::readable(s), middle - 1.45 * view.up());
    }
  for (int row = 0; row < 2; ++row)
    scene.label(row == 0 ? program.say({"numbers", "數字"}) : program.say({"angle", "角度"}),
                -1.4 * view.right() - 2.7 * row * view.up(), 0, 0, row == 0 ? colour::pink : colour::orange,
                Align::right);
  scene.make_room(-4.2 * view.right());
  Figure figure(program.studio(), "sixteen-numbers", scene.size(560));
  scene.draw(figure);
  figure.draw();
}

// Between two points of a circle: equal steps of the chord, and equal steps of the angle.
void draw_slerp(const Program& program) {
  Scene scene(View{0, 0}, 0.03);
  const double half = 65 * degree;
  const Vector a(-std::sin(half), std::cos(half), 0), b(std::sin(half), std::cos(half), 0);
  for (int panel = 0; panel < 2; ++panel) {
    const Point middle(2.6 * panel, 0, 0);
    std::vector<Point> arc;
    for (int i = 0; i <= 60; ++i) {
      const double angle = half * (i - 30) / 30 * 1.25;
      arc.push_back(middle + Vector(std::sin(angle), std::cos(angle), 0));
    }
    scene.line(arc, {colour::grey, 1.2}, 0);
    const Colour& ink = panel == 0 ? colour::pink : colour::green;
    if (panel == 0) scene.line({middle + a, middle + b}, {colour::pink, 2}, 1);
    for (int i = 0; i <= 4; ++i) {
      const double s = i / 4.0, angle = half * (2 * s - 1);
      const Vector q = panel == 0 ? Vector((1 - s) * a + s * b) : Vector(std::sin(angle), std::cos(angle), 0);
      scene.line({middle, middle + q.normalized()}, {ink, 1.2}, 1);
      scene.dot(middle + q, ink);
      scene.dot(middle + q.normalized(), colour::ink);
    }
    scene.label("{/:Italic a}", middle + 1.1 * a);
    scene.label("{/:Italic b}", middle + 1.1 * b);
    scene.label(panel == 0 ? program.say({"steps of the chord", "弦等分"})
                           : program.say({"steps of the angle", "角等分"}),
                middle - Vector(0, 0.14, 0), 0, 0, ink);
  }
  scene.make_room({0, 1.12, 0});
  scene.make_room({0, -0.2, 0});
  Figure figure(program.studio(), "slerp", scene.size(560));
  scene.draw(figure);
  figure.draw();
}

}  // namespace

void draw_turns(const Program& program) {
  draw_sixteen_numbers(program);
  draw_slerp(program);
}

}  // namespace tween_bounce
