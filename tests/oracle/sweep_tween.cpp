#include "first_contact/motion/sweep_tween.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "catch.hpp"
#include "chance.hpp"
#include "first_contact/geometry/closest_point.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "first_contact/sweep/sphere_plane.hpp"
#include "first_contact/sweep/sphere_sphere.hpp"

using namespace first_contact;

namespace {

double away_from(const Point& p, const Plane& plane) { return std::abs(plane.signed_distance(p)); }
double away_from(const Point& p, const Sphere& ball) { return (p - ball.center).norm() - ball.radius; }
double away_from(const Point& p, const Environment& surface) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Triangle& t : surface.mesh().triangles())
    nearest = std::min(nearest, (p - closest_point(p, t)).norm());
  return nearest;
}

Path some_path(Chance& chance) {
  const auto points = [&](std::size_t most) {
    std::vector<Point> all;
    for (std::size_t k = chance.pick(most + 1); k > 0; --k) all.push_back(chance.vector(4));
    return all;
  };
  const bool by_length = chance.pick(2) == 0;
  switch (chance.pick(6)) {
    case 0:
      return Path();
    case 1:
      return Path::bezier(points(4), by_length);
    case 2:
      return Path::b_spline(points(5), by_length);
    case 3:
      return Path::through(points(4), by_length);
    case 4:
      return Path::hermite(chance.vector(9), chance.vector(9), by_length);
    default: {
      const Point joint = chance.vector(4);
      return Path::of_legs({Path::bezier(points(2)), Path::through(points(2))}, {joint}, by_length);
    }
  }
}

Tween some_tween(Chance& chance) {
  std::vector<KeyFrame> keys;
  double time = chance.uniform(-3, 3);
  for (std::size_t k = 2 + chance.pick(3); k > 0; --k) {
    const Easing easing = ease::all()[chance.pick(ease::all().size())].easing;
    const Point place = chance.vector(4);
    keys.push_back({time, place, easing, some_path(chance)});
    time += chance.log_uniform(0.01, 10);
  }
  return Tween(std::move(keys));
}

double size_of(const Tween& tween) {
  double size = 1;
  for (const Leg& leg : tween.legs()) size = std::max(size, largest_coordinate(leg.curve()));
  return size;
}

// Dense samples up to the contact: nothing is entered by more than the gap, and at the contact it is that near. Is
// there a contact?
template <class Any>
bool is_right(const Tween& tween, double radius, const Any& obstacle) {
  const double gap = tween_gap * std::max({size_of(tween), radius, largest_coordinate(obstacle)});
  const auto contact = sweep(tween, radius, obstacle);
  const double until = contact ? contact->time : tween.end();
  for (int i = 0; i <= 3000; ++i) {
    const double time = std::lerp(tween.begin(), until, i / 3000.0);
    CAPTURE(time);
    REQUIRE(away_from(tween.at(time), obstacle) - radius >= -gap);
  }
  if (contact) REQUIRE(away_from(tween.at(until), obstacle) - radius <= 1.01 * gap);
  return contact.has_value();
}

Environment some_surface(Chance& chance) {
  std::vector<Point> vertices;
  for (int i = 0; i < 9; ++i) vertices.push_back(chance.vector(5));
  std::vector<Mesh::Face> faces;
  for (std::uint32_t i = 0; i < 5; ++i) faces.push_back({i, i + 1 + i % 3, i + 4});
  return Environment(Mesh(vertices, faces));
}

}  // namespace

TEST_CASE(
    "Random tweens never go deeper than the gap, and stop within it, against a plane, a ball and a mesh") {
  const std::uint64_t seed = 1301;
  Chance chance(seed);
  int tried = 0, hits = 0;
  for (int i = 0; i < 400; ++i) {
    CAPTURE(seed, i);
    const Tween tween = some_tween(chance);
    const double radius = chance.pick(4) == 0 ? 0 : chance.log_uniform(1e-3, 1);
    const Plane plane(chance.direction(), chance.uniform(-4, 4));
    const Point middle = chance.vector(4);
    const Sphere ball{middle, chance.log_uniform(1e-2, 2)};
    const Environment surface = some_surface(chance);
    const Point start = tween.at(tween.begin());
    if (away_from(start, plane) > radius) ++tried, hits += is_right(tween, radius, plane);
    if (away_from(start, ball) > radius) ++tried, hits += is_right(tween, radius, ball);
    if (away_from(start, surface) > radius) ++tried, hits += is_right(tween, radius, surface);
  }
  CHECK(hits > tried / 4);
  CHECK(hits < tried * 9 / 10);
}

TEST_CASE("A tween that is aimed to graze a ball is judged to within the gap") {
  const std::uint64_t seed = 1302;
  Chance chance(seed);
  for (int i = 0; i < 200; ++i) {
    const Tween tween = some_tween(chance);
    const double gap = 8 * tween_gap * size_of(tween), radius = 0.25;
    const Point middle = chance.vector(3);
    double nearest = std::numeric_limits<double>::infinity(), at = 0;
    for (int k = 0; k <= 20000; ++k)
      if (const double t = std::lerp(tween.begin(), tween.end(), k / 20000.0),
          away = (tween.at(t) - middle).norm();
          away < nearest)
        nearest = away, at = t;
    CAPTURE(seed, i, at);
    const double first = (tween.at(tween.begin()) - middle).norm();
    if (nearest < 0.5 || first <= nearest + gap) continue;  // what begins there leaves
    CHECK(sweep(tween, radius, Sphere{middle, nearest - radius + gap}));
  }
}
