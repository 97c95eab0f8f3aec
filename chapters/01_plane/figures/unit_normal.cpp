#include "figures.hpp"
#include "first_contact/figure/scene.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

void draw_unit_normal(const program::Program& program) {
  struct Case {
    double length;
    std::string name;
    program::Text meaning;
  };
  const std::vector<Case> cases{
      {0.5, "½", {"floats", "懸空"}}, {1.0, "1", {"touches", "接觸"}}, {2.0, "2", {"sinks in", "陷入"}}};
  figure::Scene scene({0, 0}, 0.02);
  const double r = 0.8, apart = 2.9;
  scene.polygon({{-1.6, -0.95, 0}, {2 * apart + 1.35, -0.95, 0}, {2 * apart + 1.35, 0, 0}, {-1.6, 0, 0}},
                {colour::floor}, -2);
  double x = 0;
  for (const Case& each : cases) {
    const bool right = each.length == 1;
    const Colour tone = right ? colour::green : colour::pink;
    const Point s(x, r / each.length, 0), foot(x, 0, 0);
    scene.sphere({s, r}, colour::amber, right ? 1 : 0.55);
    scene.line({s, foot}, {tone, 2.2}, 3);
    scene.arrow({x - 1.2, 0, 0}, {x - 1.2, each.length, 0}, {colour::ink, 2.4});
    scene.dot(s);
    scene.label("|{/:Bold N}| = " + each.name, {x, -0.34, 0}, 0, 0);
    scene.label(program.say(each.meaning), {x, -0.68, 0}, 0, 0, tone);
    x += apart;
  }
  scene.line({{-1.6, 0, 0}, {2 * apart + 1.35, 0, 0}}, {colour::blue, 2}, 2);
  Figure figure(program.studio(), "unit-normal", scene.size());
  scene.draw(figure);
  figure.draw();
}
