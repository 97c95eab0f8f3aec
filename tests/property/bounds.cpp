#include "first_contact/geometry/bounds.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <vector>

// The order matters: Catch2 before RapidCheck.
#include "catch.hpp"
//
#include <rapidcheck.h>
#include <rapidcheck/catch.h>

using namespace first_contact;
using Exact = boost::multiprecision::cpp_bin_float_50;

namespace {

double number() {
  const int coarse = *rc::gen::inRange(-4, 5), fine = *rc::gen::inRange(-1000000, 1000001);
  const double value = *rc::gen::arbitrary<bool>() ? coarse / 4.0 : fine / 1000003.0;
  return value * std::exp2(*rc::gen::inRange(-3, 4));
}

Vector vector() { return {number(), number(), number()}; }

Bounds box() {
  const Point a = vector(), b = vector();
  return {a.cwiseMin(b), a.cwiseMax(b)};
}

bool holds(const Bounds& box, const Point& p, double slack = 0) {
  return (p.array() >= box.min().array() - slack).all() && (p.array() <= box.max().array() + slack).all();
}

/// What of a triangle is in a box, by cutting it along the six sides (Sutherland and Hodgman, 1974).
std::vector<Point> clipped(const Triangle& triangle, const Bounds& box) {
  std::vector<Point> outline{triangle.a, triangle.b, triangle.c};
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2;
    const double sign = side % 2 ? 1 : -1, limit = side % 2 ? box.min()[axis] : -box.max()[axis];
    std::vector<Point> kept;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Point &p = outline[i], &q = outline[(i + 1) % outline.size()];
      const double at_p = sign * p[axis] - limit, at_q = sign * q[axis] - limit;
      if (at_p >= 0) kept.push_back(p);
      if ((at_p < 0) != (at_q < 0)) kept.emplace_back(p + at_p / (at_p - at_q) * (q - p));
    }
    outline = kept;
  }
  return outline;
}

}  // namespace

TEST_CASE("The bounds of a moving sphere hold all of it, to the last bit") {
  rc::prop("in exact arithmetic", [] {
    const Sphere sphere(vector(), std::abs(number()));
    const Vector v = vector();
    const Bounds bounds = bounds_of(sphere, v);
    for (int axis = 0; axis < 3; ++axis)
      for (const double t : {0.0, 1.0}) {
        // Fifty digits hold these sums exactly.
        const Exact center = Exact(sphere.center[axis]) + t * Exact(v[axis]);
        RC_ASSERT(bounds.min()[axis] <= center - sphere.radius);
        RC_ASSERT(bounds.max()[axis] >= center + sphere.radius);
      }
  });
}

TEST_CASE("A moving point is in a box during its passage and at no other time") {
  rc::prop("for motions in any direction, along the sides too", [] {
    const Bounds b = box();
    const Point start = vector();
    Vector v = vector();
    for (int axis = 0; axis < 3; ++axis)
      if (*rc::gen::inRange(0, 3) == 0) v[axis] = *rc::gen::element(0.0, -0.0);
    const auto inside = passage(start, v, b);
    const double slack = 1e-14 * (largest_coordinate(b) + start.norm() + v.norm());
    for (int i = 0; i <= 64; ++i) {
      const double t = i / 64.0;
      const Point p = start + t * v;
      if (holds(b, p, -slack)) RC_ASSERT(inside && inside->enter <= t && t <= inside->leave);
      if (inside && inside->enter <= t && t <= inside->leave) RC_ASSERT(holds(b, p, slack));
    }
  });
}

TEST_CASE("What reaches a box reaches every larger box") {
  rc::prop("to the last bit: this is what a tree relies on", [] {
    Bounds small = box(), large = small;
    large.extend(box());
    const Point start = vector();
    const Vector v = vector();
    if (passage(start, v, small)) RC_ASSERT(passage(start, v, large).has_value());
    if (overlap(small, box())) RC_ASSERT(overlap(small, large));
  });
}

TEST_CASE("A triangle and a box overlap if something is left of the triangle within the box") {
  rc::prop("by thirteen directions as by cutting", [] {
    const Bounds b = box();
    const Triangle triangle(vector(), vector(), vector());
    const double slack = 1e-13 * (largest_coordinate(b) + largest_coordinate(bounds_of(triangle)));
    Bounds smaller = grown(b, -slack);
    const bool thick = (smaller.min().array() <= smaller.max().array()).all();
    if (thick && !clipped(triangle, smaller).empty()) RC_ASSERT(overlap(triangle, b));
    if (clipped(triangle, grown(b, slack)).empty()) RC_ASSERT_FALSE(overlap(triangle, b));
  });
}
