#include <cmath>
#include <numbers>

#include "figures.hpp"
#include "parts.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

void draw_gap(const program::Program& program) {
  const double angle = 14 * std::numbers::pi / 180, gap = 0.6;
  const Vector along(std::cos(angle), 0, -std::sin(angle));
  const Point q(0, 0, 0), before = q - gap * along, kept = q - gap / std::sin(angle) * along;
  const Vector beside = 0.1 * Vector(std::sin(angle), 0, std::cos(angle));
  const auto foot = [](const Point& p) { return Point(p.x(), 0, 0); };
  std::vector<Point> arc;
  for (double part = 0; part <= 1; part += 0.125)
    arc.emplace_back(-1.5 * std::cos(part * angle), 0, 1.5 * std::sin(part * angle));

  figure::Scene scene(from_the_side, 0.03);
  scene.line({{-4.1, 0, 0}, {1.1, 0, 0}}, offset_edge, 0);
  scene.polygon({{-4.1, 0, -0.75}, {1.1, 0, -0.75}, {1.1, 0, -1}, {-4.1, 0, -1}}, {colour::floor}, -3);
  scene.line({{-4.1, 0, -0.75}, {1.1, 0, -0.75}}, {colour::blue, 1.6}, -2);
  scene.arrow(q - 4.2 * along, q);
  scene.line(arc, {colour::grey, 1.2});
  scene.line({before + beside, q + beside}, {colour::pink, 3}, 3);
  scene.line({before, foot(before)}, {colour::pink, 3}, 3);
  scene.line({kept, foot(kept)}, {colour::green, 3}, 3);
  for (const Point& dot : {q, before, kept}) scene.dot(dot);
  scene.label("{/:Italic Q}", q, 0.6, -0.9);
  scene.label("{/:Italic θ}", arc[4], -0.9, 0, colour::grey);
  scene.label("{/:Italic g}", 0.5 * (before + q), 0.6, 1.2, colour::pink);
  scene.label("{/:Italic g} sin {/:Italic θ}", foot(before), 0, -0.9, colour::pink);
  scene.label("{/:Italic g}", 0.5 * (kept + foot(kept)), -0.9, 0, colour::green);
  scene.label(program.say({"along the normal", "沿法向量"}), foot(kept), 0, -0.9, colour::green);
  scene.label(program.say({"along the path", "沿路徑"}), before, 3.5, 2.5, colour::pink);
  scene.label("{/:Italic E}′", {1.1, 0, 0}, -0.4, 0.7, colour::grey, Align::right);
  scene.label("{/:Italic E}", {1.1, 0, -0.75}, -0.4, 0.7, colour::blue, Align::right);
  Figure figure(program.studio(), "gap", scene.size());
  scene.draw(figure);
  figure.draw();
}
