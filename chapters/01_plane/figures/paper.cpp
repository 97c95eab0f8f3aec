#include "figures.hpp"
#include "parts.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

void draw_definition(const Studio& studio) {
  figure::Scene scene({66, 28});
  const Point p(-0.5, 0.1, 0), q(1.2, -0.55, 0);
  scene.patch({0, 0, 0}, {2.1, 0, 0}, {0, 1.5, 0}, {colour::floor, 1, false, plane_edge}, -1);
  const double corner = 0.2;
  const Vector along = corner * (q - p).normalized(), up(0, 0, corner);
  scene.line({p + along, p + along + up, p + up}, {colour::grey, 1.2});
  scene.arrow(p, q, {colour::green, 2.4});
  scene.arrow(p, p + Vector(0, 0, 1.5), {colour::ink, 2.4});
  scene.dot(p);
  scene.dot(q);
  scene.label("{/:Bold N}", p + Vector(0, 0, 1.5), 1.4, -0.2);
  scene.label("{/:Italic P}", p, -0.9, -0.6);
  scene.label("{/:Italic Q}", q, 1.1, -0.2);
  scene.label("{/:Italic Q} − {/:Italic P}", 0.5 * (p + q), 0.2, -1.1, colour::green);
  scene.label("{/:Italic E}", {2.1, 1.5, 0}, 0.6, 0, colour::blue, Align::left);
  Figure figure(studio, "figure-02", scene.size());
  scene.draw(figure);
  figure.draw();
}

void draw_touch(const Studio& studio) {
  figure::Scene scene({72, 24});
  const double r = 0.8;
  const Point s(0.1, 0, r), foot(0.1, 0, 0);
  scene.patch({0, 0, 0}, {2.2, 0, 0}, {0, 1.4, 0}, {colour::floor, 1, false, plane_edge}, -2);
  scene.disc(foot, {0, 0, 1}, 0.62, {colour::shadow}, -1);
  scene.sphere({s, r}, colour::amber, 0.55);
  scene.patch({0, 0, r}, {2.2, 0, 0}, {0, 1.4, 0}, {colour::floor, 0, false, offset_edge}, 1);
  scene.line({s, foot}, {colour::red, 2.0});
  scene.arrow({-1.7, -0.9, 0}, {-1.7, -0.9, r}, {colour::ink, 2.4});
  scene.dot(s);
  scene.dot(foot);
  scene.label("{/:Italic S}", s, 1.0, 0.5);
  scene.label("{/:Italic C}", foot, 1.0, -0.4);
  scene.label("{/:Italic r}", 0.5 * (s + foot), 0.9, 0, colour::red);
  scene.label("{/:Bold N}", {-1.7, -0.9, r}, 1.4, -0.4);
  scene.label("{/:Italic E}", {2.2, 1.4, 0}, 0.6, 0, colour::blue, Align::left);
  scene.label("{/:Italic E}′", {2.2, 1.4, r}, 0.6, 0, colour::grey, Align::left);
  Figure figure(studio, "figure-03", scene.size());
  scene.draw(figure);
  figure.draw();
}
