#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "figures.hpp"
#include "first_contact/figure/scene.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

namespace {

void add_disc(figure::Scene& scene, const Point& center, double radius, double opacity) {
  std::vector<Point> rim;
  for (int i = 0; i <= 72; ++i) {
    const double angle = 2 * std::numbers::pi * i / 72;
    rim.emplace_back(center + radius * Vector(std::cos(angle), 0, std::sin(angle)));
  }
  scene.polygon(rim, {colour::amber, opacity, false, Pen{colour::orange, 1.2}}, 3);
}

}  // namespace

void draw_support(const Studio& studio) {
  const std::array<Point, 3> corner{Point(1.75, 0, -1.25), Point(4.1, 0, -0.4), Point(2.5, 0, 1.7)};
  const Point p(-2.6, 0, -0.6);
  const Vector v(3.9, 0, -0.5);
  const double r = 0.75, angle = 15 * std::numbers::pi / 180;
  const Vector q(std::cos(angle), 0, std::sin(angle)), along(-q.z(), 0, q.x());  // the figure's q is 1 long

  double s = 1e9;
  for (const Point& each : corner) s = std::min(s, q.dot(each - p));
  const double tau = (s - r) / q.dot(v);
  const Point foot = p + s * q, later = p + tau * v;

  figure::Scene scene({90, 0}, 0.03);  // x to the right, z up
  scene.polygon({corner[0], corner[1], corner[2]}, {colour::floor, 1, false, Pen{colour::blue, 1.6}}, 0);
  scene.line({foot - 2.2 * along, foot + 2.3 * along}, {colour::green, 2.0, true}, 1);
  scene.line({p, p + 1.9 * along}, {colour::grey, 1.0, true}, 1);
  add_disc(scene, p, r, 1);
  add_disc(scene, later, r, 0.4);
  scene.arrow(p, later, {colour::red, 2.4}, 4);
  scene.arrow(p, p + 1.5 * q, {colour::green, 2.4}, 5);
  const Point middle = p + 0.5 * s * q + 1.75 * along;
  scene.arrow(middle, p + 1.75 * along, {colour::ink, 1.6});
  scene.arrow(middle, foot + 1.75 * along, {colour::ink, 1.6});
  scene.dot(p);
  scene.dot(later);
  scene.dot(corner[0], colour::blue);
  scene.label("{/:Bold p}", p, -0.9, -0.6);
  scene.label("{/:Bold p} + {/:Italic τ} {/:Bold v}", later, 0, -1.1);
  scene.label("{/:Bold v}", p + 0.7 * tau * v, 0, -0.9, colour::red);
  scene.label("{/:Bold q}", p + 1.5 * q, 0.4, 0.9, colour::green);
  scene.label("{/:Italic s} / |{/:Bold q}|", middle, -0.6, 1.1);
  scene.label("{/:Bold a}", corner[0], 1.3, -0.6, colour::blue);
  scene.arrow(later, later + r * q, {colour::ink, 1.6}, 5);
  scene.label("{/:Italic r}", later + 0.5 * r * q, -0.2, 1);
  Figure figure(studio, "support", scene.size());
  scene.draw(figure);
  figure.draw();
}
