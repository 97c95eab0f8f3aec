#include <algorithm>
#include <cmath>
#include <numbers>

#include "figures.hpp"
#include "first_contact/figure/scene.hpp"
#include "first_contact/sweep/sphere_sphere.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

namespace {

const View front{90, 0};  // at right angles to the plane of the motion

// A right angle's mark at `corner`, between two unit vectors.
void add_right_angle(figure::Scene& scene, const Point& corner, const Vector& u, const Vector& v,
                     double size) {
  scene.line({corner + size * u, corner + size * (u + v), corner + size * v}, {colour::grey, 1.2});
}

std::vector<Point> circle(double radius) {
  std::vector<Point> points;
  for (int degrees = 0; degrees < 360; degrees += 2) {
    const double angle = degrees * std::numbers::pi / 180;
    points.emplace_back(radius * std::cos(angle), 0, radius * std::sin(angle));
  }
  return points;
}

}  // namespace

// Drawn in the plane of w and u: x along u, z along the closest approach.
void draw_closest_approach(const Studio& studio, const Moving<Sphere>& p, const Moving<Sphere>& q) {
  const Vector w = p.shape.center - q.shape.center, u = p.displacement - q.displacement;
  if (u == Vector::Zero()) return;
  const double d = p.shape.radius + q.shape.radius, speed = u.norm();
  const double miss = accurate_cross(w, u).norm() / speed, start = w.dot(u) / speed;
  const auto times = contact_interval(p, q);
  const auto on_path = [&](double x) { return Point(x, 0, miss); };
  const double last = std::max({start + speed, times ? start + times->end * speed + 0.3 * d : d, 1.2 * d});
  const double first = std::min(start, -1.2 * d);
  const Point origin(0, 0, 0);

  figure::Scene scene(front, 0.07);
  scene.polygon(circle(d), {colour::floor, 1, false, Pen{colour::blue, 1.4}}, -1);
  scene.line({on_path(first), on_path(last)}, {colour::grey, 1.2, true}, 0);
  scene.arrow(on_path(start), on_path(start + speed));
  scene.line({origin, on_path(0)}, {colour::ink, 1.8});
  scene.dot(origin, colour::blue);
  scene.dot(on_path(start));
  scene.label("{/:Italic Q}", origin, 0, -1.0, colour::blue);
  scene.label("{/:Italic P}", on_path(start), 0, -1.0);
  scene.label("{/:Bold u}", on_path(start + 0.25 * speed), 0, 0.9, colour::red);
  scene.label("|{/:Bold w} × {/:Bold u}| / |{/:Bold u}|", 0.45 * on_path(0), 0.6, 0, colour::ink,
              Align::left);
  if (times) {
    const Point enter = on_path(start + times->begin * speed), leave = on_path(start + times->end * speed);
    add_right_angle(scene, on_path(0), {-1, 0, 0}, {0, 0, -1}, 0.12 * d);
    scene.line({origin, enter}, {colour::blue, 1.8});
    scene.line({enter, on_path(0)}, {colour::green, 3.4}, 3);
    scene.dot(enter);
    scene.dot(leave);
    scene.label("{/:Italic d}", 0.5 * enter, -0.6, -0.8, colour::blue);
    scene.label("{/:Italic t}_1", enter, -0.8, 0.9);
    scene.label("{/:Italic t}_2", leave, 0.9, 0.9);
    scene.label("√{/:Italic D} / |{/:Bold u}|", 0.5 * (enter + on_path(0)), 0, 0.9, colour::green);
  }
  Figure figure(studio, "closest-approach", scene.size());
  scene.draw(figure);
  figure.draw();
}
