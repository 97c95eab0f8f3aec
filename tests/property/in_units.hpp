#pragma once
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "catch.hpp"
#include "chance.hpp"
#include "first_contact/geometry/bounds.hpp"
#include "first_contact/geometry/box.hpp"
#include "first_contact/geometry/mesh.hpp"
#include "first_contact/geometry/plane.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/geometry/triangle.hpp"
#include "first_contact/sweep/contact.hpp"

/// \file
/// The range of numbers that contact.hpp promises: a scene multiplied by a power of two has the same answer, the
/// time to the last bit and the points multiplied by it.

namespace in_units {

using namespace first_contact;

/// The powers of two: the ends of the range, and between them.
inline constexpr int powers[]{-895, -700, -300, -100, -40, 40, 100, 300, 600, 900, 997};

/// Numbers of few digits, so that they are exact in every unit.
class Scene {
 public:
  explicit Scene(std::uint64_t seed) : chance_(seed) {}

  double number(double low, double high) { return std::round(0x1p16 * chance_.uniform(low, high)) / 0x1p16; }
  Vector vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
  Moving<Sphere> ball() {
    const Point start = vector(4);
    return {{start, number(0, 1)}, vector(1) - 1.5 * start};
  }
  /// Upright or turned, by numbers that make its axes perpendicular but for rounding; it may be flat.
  Box box() {
    const double w = number(-1, 1), x = number(-1, 1), y = number(-1, 1), z = number(0.25, 1);
    const Eigen::Matrix3d turn = chance_.pick(2)
                                     ? Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix()
                                     : Eigen::Matrix3d::Identity();
    const double r = number(0, 2), s = chance_.pick(5) ? number(0, 2) : 0, t = number(0, 2);
    return {vector(2), r * turn.col(0), s * turn.col(1), t * turn.col(2)};
  }
  Triangle triangle() {
    const Point a = vector(2), b = vector(2);
    return {a, b, vector(2)};
  }
  Mesh mesh() {
    std::vector<Point> vertices;
    for (int i = 0; i < 12; ++i) vertices.push_back(vector(2));
    std::vector<Mesh::Face> faces;
    for (int i = 0; i < 8; ++i) {
      const auto a = static_cast<std::uint32_t>(chance_.pick(12));
      faces.push_back({a, (a + 1 + static_cast<std::uint32_t>(chance_.pick(5))) % 12, (a + 7) % 12});
    }
    return {vertices, faces};
  }
  Chance& chance() { return chance_; }

 private:
  Chance chance_;
};

inline double times(double length, int power) { return std::ldexp(length, power); }
inline Vector times(const Vector& v, int power) {
  return {times(v.x(), power), times(v.y(), power), times(v.z(), power)};
}
inline Sphere times(const Sphere& s, int power) { return {times(s.center, power), times(s.radius, power)}; }
/// With the very same normal: made anew, it would be divided by its length once more.
inline Plane times(const Plane& e, int power) {
  return e.moved_out(e.offset()).moved_out(-times(e.offset(), power));
}
inline Box times(const Box& b, int power) {
  return {times(b.center, power), times(b.r, power), times(b.s, power), times(b.t, power)};
}
inline Bounds times(const Bounds& b, int power) {
  return bounds_between(times(Vector(b.min()), power), times(Vector(b.max()), power));
}
inline Triangle times(const Triangle& t, int power) {
  return {times(t.a, power), times(t.b, power), times(t.c, power)};
}
template <class Shape>
Moving<Shape> times(const Moving<Shape>& moving, int power) {
  return {times(moving.shape, power), times(moving.displacement, power)};
}
template <class Thing>
std::vector<Thing> times(const std::vector<Thing>& things, int power) {
  std::vector<Thing> all;
  for (const Thing& thing : things) all.push_back(times(thing, power));
  return all;
}
inline Mesh times(const Mesh& mesh, int power) { return {times(mesh.vertices(), power), mesh.faces()}; }

/// Equal but for the rounding to the smallest doubles, which is all that another unit may do.
inline void check_scaled(double answer, double at_size_1, int power) {
  REQUIRE(std::abs(answer - times(at_size_1, power)) <= 2 * std::numeric_limits<double>::denorm_min());
}
inline void check_scaled(const Vector& answer, const Vector& at_size_1, int power) {
  for (int k = 0; k < 3; ++k) check_scaled(answer[k], at_size_1[k], power);
}
inline void check_scaled(const std::optional<Contact>& answer, const std::optional<Contact>& at_size_1,
                         int power) {
  REQUIRE(answer.has_value() == at_size_1.has_value());
  if (!answer) return;
  REQUIRE(answer->time == at_size_1->time);
  REQUIRE(answer->normal == at_size_1->normal);
  REQUIRE(answer->feature == at_size_1->feature);
  REQUIRE(answer->triangle == at_size_1->triangle);
  REQUIRE(answer->points.cols() == at_size_1->points.cols());
  for (Eigen::Index k = 0; k < answer->points.cols(); ++k)
    check_scaled(Vector(answer->points.col(k)), Vector(at_size_1->points.col(k)), power);
}

/// Asks `ask(scene)` for so many scenes; it compares by check_scaled what it finds in other units with what it finds
/// at size 1.
template <class Ask>
void in_every_unit(std::uint64_t seed, int rounds, const Ask& ask) {
  Scene scene(seed);
  for (int i = 0; i < rounds; ++i) {
    CAPTURE(seed, i);
    ask(scene);
  }
}

/// The answer of `ask(things...)` at size 1, and in every other unit: the same.
template <class Ask, class... Things>
void check_in_every_unit(const Ask& ask, const Things&... things) {
  const auto at_size_1 = ask(things...);
  for (const int power : powers) {
    CAPTURE(power);
    check_scaled(ask(times(things, power)...), at_size_1, power);
  }
}

}  // namespace in_units
