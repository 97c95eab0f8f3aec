#include <cmath>
#include <numbers>

#include "figures.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"
#include "parts.hpp"
#include "rounded.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

void draw_moved_out(const Studio& studio) {
  figure::Scene scene(from_above);
  const double r = 0.7;
  const std::vector<Point> corners{at(-2.2, -1), at(1.6, -1), at(2.1, 0.2), at(0.9, 1), at(-1.7, 0.8)};
  scene.polygon(corners, solid);
  scene.line(rounded_outline(corners, r), moved_out);
  const Vector along = corners[4] - corners[3], n = Vector(along.y(), -along.x(), 0).normalized();
  const Point foot = corners[3] + 0.62 * along, c = foot + r * n;
  const Point corner = corners[2] + r * at(0.9, 0.2).normalized();
  scene.sphere({c, r}, colour::amber, 0.5);
  scene.sphere({corner, r}, colour::amber, 0.25);
  scene.line({c, foot}, {colour::red, 2.0});
  scene.line({corner, corners[2]}, {colour::red, 2.0});
  scene.dot(c);
  scene.dot(corner);
  scene.label("{/:Italic C}", c, -0.9, 0.5);
  scene.label("{/:Italic C}", corner, 1.0, 0.3);
  scene.label("{/:Italic r}", 0.5 * (c + foot), 0.8, 0, colour::red);
  finish(studio, "figure-06", scene);
}

void draw_face_first(const Studio& studio) {
  figure::Scene scene(from_above);
  const double r = 1;
  scene.polygon({at(-2.6, -1.3), at(0, -1.3), at(0, 0), at(-2.6, 0)}, {colour::floor});
  scene.line({at(0, -1.3), at(0, 0), at(-2.6, 0)}, {colour::blue, 1.6});
  scene.line({at(-2.6, r), at(0, r)}, moved_out);
  scene.line({at(r, 0), at(r, -1.3)}, moved_out);
  scene.line(arc(at(0, 0), r), {colour::green, 1.4, true});
  const Point start = at(-2.0, 2.3), a = at(-1.05, r);
  const Vector path = a - start;
  const Contact b = *sweep(Moving<Sphere>{{start, r}, 3 * path}, Triangle(at(0, 0), at(0, 0), at(0, 0)));
  const Point inside = start + b.time * 3 * path;
  scene.line({start, start + 2.6 * path}, {colour::red, 1.0, true});
  scene.arrow(start, a);
  scene.dot(a);
  scene.dot(inside);
  scene.dot(at(0, 0));
  scene.label("{/:Italic A}", a, 0.9, 0.7);
  scene.label("{/:Italic B}", inside, -1.1, -0.3);
  scene.label("{/:Italic r}", at(0.62, 0.42), 0, 0, colour::green);
  scene.line({at(0, 0), at(std::sqrt(0.5), std::sqrt(0.5))}, {colour::green, 1.4});
  finish(studio, "figure-07", scene);
}

void draw_valley(const Studio& studio) {
  figure::Scene scene(from_above);
  const double r = 0.9;
  scene.polygon({at(-1.0, -0.9), at(3.2, -0.9), at(3.2, 0), at(0, 0), at(0, 2.5), at(-1.0, 2.5)},
                {colour::floor});
  scene.line({at(3.2, 0), at(0, 0), at(0, 2.5)}, {colour::blue, 1.6});
  scene.line({at(3.2, r), at(r, r), at(r, 2.5)}, moved_out);
  scene.line(arc(at(0, 0), r), {colour::green, 1.4, true});
  scene.sphere({at(r, r), r}, colour::amber, 0.5);
  scene.dot(at(0, 0));
  scene.dot(at(r, r));
  scene.label("{/:Italic C}", at(r, r), -0.9, 0.7);
  scene.arrow(at(3.0, 2.2), at(r + 0.06, r + 0.04));
  finish(studio, "figure-08", scene);
}

void draw_jar(const Studio& studio) {
  figure::Scene scene(from_above);
  const double r = 0.5;
  const std::vector<Point> inner{at(-2, 2.2), at(-2, 0), at(-1.1, 0), at(0, 0.55),
                                 at(1.1, 0),  at(2, 0),  at(2, 2.2)};
  std::vector<Point> wall = inner;
  for (const Point& p : {at(2.3, 2.2), at(2.3, -0.4), at(-2.3, -0.4), at(-2.3, 2.2)}) wall.push_back(p);
  scene.polygon(wall, {colour::floor});
  scene.line(inner, {colour::blue, 1.6});
  const Vector n = Vector(-0.55, 1.1, 0).normalized();
  const double angle = std::atan2(n.y(), n.x()) * 180 / pi, bend = r * std::tan((90 - angle) / -2 * pi / 180);
  std::vector<Point> half{at(-2 + r, 2.2), at(-2 + r, r), at(-1.1 - bend, r)};
  for (const Point& p : arc(at(0, 0.55), r, angle, 90)) half.push_back(p);
  std::vector<Point> centres = half;
  for (auto p = half.rbegin(); p != half.rend(); ++p) centres.push_back(at(-p->x(), p->y()));
  scene.line(centres, moved_out);
  scene.line(arc(at(-1.1, 0), r), {colour::green, 1.4, true});
  scene.dot(at(-1.1, 0));
  scene.label("{/:Italic A}", at(-1.1, 0), 0, -0.9);
  scene.sphere({at(-1.1 - bend, r), r}, colour::amber, 0.4);
  scene.dot(at(-1.1 - bend, r));
  finish(studio, "figure-09", scene);
}
