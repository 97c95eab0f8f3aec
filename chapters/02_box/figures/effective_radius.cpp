#include <cmath>

#include "figures.hpp"
#include "parts.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

namespace {

// The three parts of 2 r_eff, one upon the other.
void draw_gauge(figure::Scene& scene, Point gauge, const Box& box, const Vector& n) {
  const auto measure = [&](const std::string& axis, const Vector& edge, const Colour& of) {
    const Point upper = gauge + std::abs(edge.dot(n)) * n;
    scene.line({gauge, upper}, {of, 4.0}, 3);
    scene.label("|{/:Bold " + axis + "}·{/:Bold N}|", 0.5 * (gauge + upper), 0.8, 0, of, Align::left);
    gauge = upper;
  };
  measure("S", box.s, colour::green);
  measure("R", box.r, colour::red);
  measure("T", box.t, colour::pink);
  scene.label("", gauge + Vector(0.75, 0, 0));  // room for what stands beside the gauge
}

}  // namespace

void draw_effective_radius(const Studio& studio) {
  const Vector n(0, 0, 1);
  const Box box{{0, 0, 1.15}, {0.6, 1.2, 1.2}, {0.8, 0.4, -0.8}, {0.6, -0.6, 0.3}};
  const double radius = box.effective_radius(n);
  const Vector half_u(2.0, 0, 0), half_v(0, 1.3, 0), foot(0, 0, 0);
  figure::Scene scene({74, 24}, 0.05);
  scene.patch(foot, half_u, half_v, plane_fill, -3);
  scene.polygon(shadow(box, Plane(n, 0)), {colour::shadow}, -2);
  scene.patch(radius * n, half_u, half_v, offset_fill, 1);
  scene.box(box, glass);
  const Point lowest = lowest_vertices(box, n).col(0);
  const Point second = lowest - box.s, third = second + box.r;
  scene.arrow(second, lowest, {colour::green, 2.4});
  scene.arrow(second, third, {colour::red, 2.4});
  scene.arrow(third, third + box.t, {colour::pink, 2.4});
  scene.label("{/:Bold S}", 0.5 * (second + lowest), -1.0, -0.7, colour::green);
  scene.label("{/:Bold R}", 0.62 * second + 0.38 * third, -1.1, 0.5, colour::red);
  scene.label("{/:Bold T}", third + 0.5 * box.t, -0.2, 0.9, colour::pink);

  draw_gauge(scene, half_u + half_v, box, n);
  scene.line({box.center, foot}, {colour::ink, 2.0}, 2);
  scene.dot(box.center);
  scene.dot(foot);
  scene.dot(lowest);
  scene.label("{/:Italic Q}", box.center, 0.9, 0.4);
  scene.label("{/:Italic r}_{eff}", 0.76 * box.center, 1.8, 0);
  scene.label("{/:Italic C}", lowest, 0.2, -0.9);
  const Point corner = -half_u - half_v;
  scene.label("{/:Italic E}", corner, -0.7, 0, colour::blue, Align::right);
  scene.label("{/:Italic E}′", corner + radius * n, -0.7, 0, colour::grey, Align::right);
  scene.label("", corner - Vector(0.25, 0, 0));
  scene.arrow(corner + Vector(0.3, 0.25, 0), corner + Vector(0.3, 0.25, 0.8), {colour::ink, 2.4});
  scene.label("{/:Bold N}", corner + Vector(0.3, 0.25, 0.8), 1.5, -0.3);
  Figure figure(studio, "figure-04", scene.size());
  scene.draw(figure);
  figure.draw();
}
