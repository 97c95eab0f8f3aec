#include "first_contact/stage/hit_test.hpp"

#include <cmath>
#include <vector>

// The order matters: Catch2 before RapidCheck.
#include "catch.hpp"
#include "wide.hpp"
//
#include <rapidcheck.h>
#include <rapidcheck/catch.h>

using namespace first_contact;

namespace {

double number() {
  const int coarse = *rc::gen::inRange(-4, 5), fine = *rc::gen::inRange(-1000000, 1000001);
  return *rc::gen::arbitrary<bool>() ? coarse / 4.0 : fine / 1000003.0;
}

std::vector<Point2> outline() {
  std::vector<Point2> corners;
  const int count = *rc::gen::inRange(1, 9);
  for (int i = 0; i < count; ++i) corners.emplace_back(number(), number());
  return corners;
}

Wide cross(const Point2& a, const Point2& b, const Point2& p) {
  const Wide x = Wide(b.x()) - a.x(), y = Wide(b.y()) - a.y();
  return x * (Wide(p.y()) - a.y()) - y * (Wide(p.x()) - a.x());
}

/// Even-odd by fans: a point is in the shape if it is in an odd number of the triangles (first corner, side).
bool in_an_odd_number_of_triangles(const std::vector<Point2>& outline, const Point2& p) {
  bool odd = false;
  for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
    const Wide u = cross(outline[0], outline[i], p), v = cross(outline[i], outline[i + 1], p),
               w = cross(outline[i + 1], outline[0], p);
    if ((u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0)) odd = !odd;
  }
  return odd;
}

double distance(const Point2& a, const Point2& b, const Point2& p) {
  const Point2 e = b - a;
  const double t = e.squaredNorm() > 0 ? std::clamp((p - a).dot(e) / e.squaredNorm(), 0.0, 1.0) : 0.0;
  return (a + t * e - p).norm();
}

/// Of p from the outline, and from the lines that part it into a fan of triangles.
double distance(const std::vector<Point2>& outline, const Point2& p, bool with_fan) {
  double least = 10;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    least = std::min(least, distance(outline[i], outline[(i + 1) % outline.size()], p));
    if (with_fan) least = std::min(least, distance(outline[0], outline[i], p));
  }
  return least;
}

}  // namespace

TEST_CASE("A point is in a shape by rays as it is by triangles, for any outline that may cross itself") {
  rc::prop("away from the boundary", [] {
    const auto corners = outline();
    const Point2 p(number(), number());
    RC_PRE(distance(corners, p, true) > 1e-14);
    RC_ASSERT(hit_test_point(StageObject(corners), p, true) == in_an_odd_number_of_triangles(corners, p));
  });
}

TEST_CASE("Every point of the boundary is in the shape, and a shape is in its bounding box") {
  rc::prop("up to rounding", [] {
    const auto corners = outline();
    const StageObject object(corners);
    const auto i = *rc::gen::inRange<std::size_t>(0, corners.size());
    const double t = *rc::gen::inRange(0, 257) / 256.0;
    const Point2 p = corners[i] + t * (corners[(i + 1) % corners.size()] - corners[i]);
    if (object.bounding_box().contains(p)) RC_ASSERT(hit_test_point(object, p, true));
    const Point2 q(number(), number());
    if (hit_test_point(object, q, true)) RC_ASSERT(hit_test_point(object, q, false));
  });
}

TEST_CASE("Shapes that overlap have boxes that overlap, in either order, and each overlaps itself") {
  rc::prop("for any outlines", [] {
    const StageObject a(outline()), b(outline());
    RC_ASSERT(overlap(a, b) == overlap(b, a));
    if (overlap(a, b)) RC_ASSERT(hit_test_object(a, b));
    RC_ASSERT(hit_test_object(a, b) == hit_test_object(b, a));
    RC_ASSERT(overlap(a, a));
    for (const Point2& corner : a.outline())
      if (hit_test_point(b, corner, true)) RC_ASSERT(overlap(a, b));
  });
}
