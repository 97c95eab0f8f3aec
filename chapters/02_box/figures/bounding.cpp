#include <cmath>

#include "figures.hpp"
#include "first_contact/geometry/transform.hpp"
#include "parts.hpp"
#include "studies.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

namespace {

std::vector<Point> circle(const Sphere& sphere) {
  std::vector<Point> points;
  points.reserve(181);
  for (int i = 0; i <= 180; ++i)
    points.emplace_back(sphere.center +
                        sphere.radius * Vector(std::cos(2 * degree * i), std::sin(2 * degree * i), 0));
  return points;
}

}  // namespace

void draw_bounding_shapes(const Studio& studio) {
  std::vector<Point> fish;
  for (int i = 0; i < 120; ++i) {
    const double a = 3 * degree * i;
    const double x = std::cos(a) - std::sin(a) * std::sin(a) / std::sqrt(2.0), y = std::cos(a) * std::sin(a);
    fish.emplace_back(0.94 * x - 0.34 * y, 0.34 * x + 0.94 * y, 0);
  }
  const Pen bound{colour::blue, 2.2}, dashed{colour::blue, 2.2, true};
  figure::Scene scene({0, 0}, 0.03);
  for (const bool round : {false, true}) {
    std::vector<Point> outline;
    for (const Point& p : fish) outline.emplace_back(p + Vector(round ? 2.5 : 0.0, 0, 0));
    scene.polygon(outline, {colour::amber, 1, false, Pen{colour::ink, 1.4}});
    scene.dot(0.62 * outline.front() + Vector(round ? 0.95 : 0.0, 0.1, 0));
    const Box box = bounding_box(outline);
    if (round)
      scene.line(circle(bounding_sphere(outline)), bound);
    else
      scene.patch(box.center, 0.5 * box.r, 0.5 * box.s, {colour::floor, 0, false, dashed}, 1);
  }
  Figure figure(studio, "figure-01", scene.size());
  scene.draw(figure);
  figure.draw();
}

void draw_tightness(const Studio& studio) {
  const box_chapter::Bounded plank = box_chapter::bounded_shapes()[0];
  const Fill hull{colour::sky, 0.22, true};
  const View view{76, 20};
  figure::Scene scene(view, 0.04);
  double place = 0;
  const auto show = [&](double bounding_volume) {
    Rigid shift = Rigid::moved_by(place * view.right());
    scene.box(shift.box(plank.turned), solid, 0);
    scene.label(box_chapter::rounded(bounding_volume / plank.volume, 1) + " {/:Italic V}",
                shift.translation() - 2.05 * view.up());
    place += 3.85;
    return shift;
  };
  scene.sphere(show(volume(plank.sphere)).sphere(plank.sphere), colour::sky, 0.22, 1);
  scene.box(show(volume(plank.upright)).box(plank.upright), hull, 1);
  const Box& snug = plank.turned;  // drawn a little too large, or nothing of it would be seen
  const auto looser = [](const Vector& axis) { return Vector(axis + 0.14 * axis.normalized()); };
  scene.box(show(volume(snug)).box({snug.center, looser(snug.r), looser(snug.s), looser(snug.t)}), hull, 1);
  Figure figure(studio, "bounding", scene.size(900));
  scene.draw(figure);
  figure.draw();
}
