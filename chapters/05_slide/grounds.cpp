#include "grounds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "first_contact/mesh_io/read_mesh.hpp"
#include "first_contact/program/terrain.hpp"
#include "places.hpp"
#include "scene.hpp"

namespace walks {

namespace {

//! [wander]
// Any way, slow to two radii per frame, each power of two as often as the next.
auto wander(double radius) {
  return [=](program::Random& random) {
    const double speed = radius * std::exp2(1 - 10 * random.number());
    const Vector way = 2 * random.vector() - Vector::Ones();
    return Vector(speed * Vector(way.x(), way.y(), 0.2 * way.z()).normalized());
  };
}

// With a pull the ball stays at the surface: down, or to a point.
auto down(double strength) {
  return [=](const Point&) { return Vector(0, 0, -strength); };
}
auto to_point(const Point& middle, double strength) {
  return [=](const Point& center) { return Vector(strength * (middle - center).normalized()); };
}
//! [wander]

auto always(const Vector& way) {
  return [=](program::Random&) { return way; };
}

//! [sides]
bool above(const Point& p, const Bvh& bvh) { return sweep({Sphere{p, 0}, {0, 0, -1000}}, bvh).has_value(); }

// The faces of a closed surface look outward: what is seen from outside shows its front.
bool outside(const Point& p, const Bvh& bvh) {
  const Vector up(0.1, 0.2, 1000);
  const auto seen = sweep({Sphere{p, 0}, up}, bvh);
  return !seen || bvh.mesh().triangle(seen->triangle).area_vector().dot(up) < 0;
}
//! [sides]

Ground hills() {
  Mesh mesh = program::terrain(100);
  double top = 0;
  for (const Point& p : mesh.vertices()) top = std::max(top, p.z());
  const Sphere ball{{32, 32, top + 1}, 0.4};
  return {{"terrain", "地形"}, std::move(mesh), ball, 28, wander(0.4), down(0.6), above};
}

Ground bunny() {
  const Point middle(0, 0, 4);
  return {{"bunny", "兔子"},
          read_mesh(std::string(places::meshes) + "/bunny.off"),
          {{4, -1.2, 9}, 0.5},
          9,
          wander(0.5),
          to_point(middle, 0.8),
          outside};
}

//! [room]
// A box, 8 by 8 by 4, with a ramp and two steps in it.
Ground room() {
  std::vector<Rectangle> sides{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}},
                               {{0, 0, 4}, {4, 0, 0}, {0, 4, 0}},
                               {{-1.5, 0, 0.5}, {1.5, 0, 0.5}, {0, 1, 0}}};
  for (const double s : {-4.0, 4.0}) {
    sides.push_back({{s, 0, 2}, {0, 4, 0}, {0, 0, 2}});
    sides.push_back({{0, s, 2}, {4, 0, 0}, {0, 0, 2}});
  }
  for (const double x : {1.0, 2.0}) {
    sides.push_back({{x, 0, x - 0.9}, {0, 4, 0}, {0, 0, 0.1}});
    sides.push_back({{x + 0.5, 0, x - 0.8}, {0.5, 0, 0}, {0, 4, 0}});
  }
  const auto inside = [](const Point& p, const Bvh&) {
    return p.head<2>().lpNorm<Eigen::Infinity>() < 4 && p.z() > 0 && p.z() < 4;
  };
  return {{"room", "房間"}, walls(sides), {{-3.5, -3, 1}, 0.3}, 9, wander(0.3), down(0.3), inside};
}
//! [room]

Ground level_floor() {
  Mesh mesh = program::height_field(100, 10, [](double, double) { return 0.0; });
  return {{"level floor", "平地"},
          std::move(mesh),
          {{1, 1, 0.315}, 0.3},
          8,
          always({0.0037, 0.0031, 0}),
          down(2),
          above,
          {0, 0, 1}};
}

Ground wedge() {
  const double half = std::numbers::pi / 12;  // 15 degrees
  const Vector one(4.5 * std::cos(half), 4.5 * std::sin(half), 0), other(one.x(), -one.y(), 0), up(0, 0, 9);
  const auto between = [=](const Point& p, const Bvh&) { return std::abs(p.y()) < p.x() * std::tan(half); };
  return {{"wedge, 30 degrees", "楔形，30 度"},
          walls({{one, one, up}, {other, other, up}}),
          {{5, 0.1, 0}, 0.3},
          9,
          always({-0.2, 0.03, 0}),
          down(0),
          between,
          {1, 1, 1}};
}

}  // namespace

std::vector<Ground> grounds() { return {hills(), bunny(), room(), level_floor(), wedge()}; }

}  // namespace walks
