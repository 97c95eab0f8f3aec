#include <cmath>
#include <numbers>
#include <vector>

#include "figures.hpp"
#include "first_contact/figure/scene.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

namespace {

/// A hill, seen from the side, cut into straight pieces half a unit long.
Point on_hill(double x) { return {x, 0, -0.12 * x * x}; }
Vector normal_between(double from, double to) {
  const Vector along = on_hill(to) - on_hill(from);
  return Vector(-along.z(), 0, along.x()).normalized();
}

/// The directions up to an angle from a normal, as a wedge.
void add_wedge(figure::Scene& scene, const Point& tip, const Vector& normal, double angle,
               const Colour& tint) {
  constexpr double length = 2.2;
  std::vector<Point> rim{tip};
  for (int i = -6; i <= 6; ++i) {
    const double turn = angle * i / 6, sine = std::sin(turn), cosine = std::cos(turn);
    rim.push_back(tip + length * Vector(cosine * normal.x() + sine * normal.z(), 0,
                                        cosine * normal.z() - sine * normal.x()));
  }
  rim.push_back(tip);
  scene.polygon(rim, {tint, 0.2, false, Pen{tint, 1.0}}, 2);
}

/// The ground's pieces, those of two leaves in colours of their own.
void add_hill(figure::Scene& scene) {
  std::vector<Point> ground;
  for (double x = -3.5; x <= 3.5; x += 0.5) ground.push_back(on_hill(x));
  scene.line(ground, {colour::ink, 2.0}, 3);
  scene.line({on_hill(1), on_hill(1.5), on_hill(2)}, {colour::blue, 4.5}, 4);
  scene.line({on_hill(-0.5), on_hill(0), on_hill(0.5)}, {colour::green, 4.5}, 4);
  for (const Point& corner : ground) scene.dot(corner);
}

}  // namespace

void draw_cones(const Studio& studio) {
  const Point center(0, 0, 1.35), touched = on_hill(1.5);
  const double r = 2.3;
  const Vector mean = normal_between(1, 2);
  const double angle = std::acos(mean.dot(normal_between(0.5, 1)));  // the piece beside the leaf counts too

  figure::Scene scene({90, 0}, 0.03);  // x to the right, z up
  std::vector<Point> rim;
  for (int i = 0; i <= 72; ++i) {
    const double turn = 2 * std::numbers::pi * i / 72;
    rim.push_back(center + r * Vector(std::cos(turn), 0, std::sin(turn)));
  }
  scene.polygon(rim, {colour::amber, 0.35, false, Pen{colour::orange, 1.2}}, 0);
  add_hill(scene);
  add_wedge(scene, touched, mean, angle, colour::blue);
  add_wedge(scene, on_hill(0), Vector::UnitZ(), angle, colour::green);
  scene.arrow(touched, touched + 1.5 * mean, {colour::blue, 2.4}, 5);
  scene.arrow(touched, center, {colour::red, 2.2}, 5);
  scene.dot(center);
  scene.label("{/:Bold c}", center, -0.9, 0.8);
  scene.label("{/:Bold x}", touched, 0.2, -1.2);
  scene.label("{/:Bold n}", touched + 1.5 * mean, 0.9, 0.2, colour::blue);
  scene.label("{/:Italic d}", touched + 0.5 * (center - touched), -0.6, -0.8, colour::red);
  scene.label("{/:Italic θ}", touched + 2.2 * mean, -0.9, 0.8, colour::blue);
  Figure figure(studio, "cones", scene.size());
  scene.draw(figure);
  figure.draw();
}
