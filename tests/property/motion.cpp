#include <rapidcheck.h>
#include <rapidcheck/catch.h>

#include <algorithm>
#include <cmath>

#include "07_tween_bounce/printed_bounce.hpp"
#include "catch.hpp"
#include "first_contact/geometry/transform.hpp"
#include "first_contact/motion/bounce.hpp"
#include "first_contact/motion/easing.hpp"
#include "first_contact/motion/sweep_along.hpp"
#include "first_contact/motion/tween.hpp"
#include "first_contact/sweep/sphere_plane.hpp"

using namespace first_contact;

namespace {

// A number of 1/1000 steps: shrinks to what a reader can see through.
double number(int low, int high) { return *rc::gen::inRange(low * 1000, high * 1000 + 1) / 1000.0; }

std::vector<Point> some_points(std::size_t count) {
  std::vector<Point> points;
  while (points.size() < count) points.emplace_back(number(-9, 9), number(-9, 9), number(-9, 9));
  return points;
}

Curve some_curve() {
  const auto count = *rc::gen::inRange<std::size_t>(2, 8);
  if (*rc::gen::arbitrary<bool>()) return Bezier(some_points(count));
  return BSpline(some_points(count), *rc::gen::inRange<std::size_t>(1, count));
}

}  // namespace

TEST_CASE("A curve stays within the convex hull of its control points: on their side of any plane") {
  rc::prop("curve in hull", [] {
    const Curve curve = some_curve();
    const Point p = at(curve, number(0, 1));
    const Vector n = some_points(1).front();
    double furthest = -1e300, size = 0;
    for (const Point& c : control_points(curve)) {
      furthest = std::max(furthest, n.dot(c));
      size = std::max(size, c.norm());
    }
    RC_ASSERT(n.dot(p) <= furthest + 1e-14 * n.norm() * size);
  });
}

TEST_CASE("A curve moved and turned is the curve of the moved and turned control points") {
  rc::prop("affine invariance", [] {
    const Rigid motion =
        Rigid::moved_by(some_points(1).front()).after(Rigid::turned({1, 2, 3}, number(-3, 3)));
    const auto points = some_points(*rc::gen::inRange<std::size_t>(3, 8));
    std::vector<Point> moved;
    for (const Point& p : points) moved.push_back(motion.point(p));
    const double u = number(0, 1);
    RC_ASSERT((Bezier(moved).at(u) - motion.point(Bezier(points).at(u))).norm() < 1e-13);
    RC_ASSERT((BSpline(moved, 2).at(u) - motion.point(BSpline(points, 2).at(u))).norm() < 1e-13);
  });
}

TEST_CASE("Equal parts of the arc length are no shorter than their chords") {
  rc::prop("arc length", [] {
    const ArcLength length(some_curve());
    const double a = number(0, 1), b = number(0, 1);
    RC_ASSERT((length.at(a) - length.at(b)).norm() <= std::abs(a - b) * length.total() + 1e-9);
    const double s = a * length.total();
    RC_ASSERT(std::abs(length.to(length.parameter(s)) - s) <= 1e-11 * length.total());
  });
}

TEST_CASE("A tween through random keys is at every key, and between two straight ones on their segment") {
  rc::prop("tween", [] {
    std::vector<KeyFrame> keys;
    double time = number(-5, 5);
    for (const Point& p : some_points(*rc::gen::inRange<std::size_t>(2, 6))) {
      const auto easing = ease::all()[*rc::gen::inRange<std::size_t>(0, ease::all().size())].easing;
      keys.push_back({time, p, easing});
      time += number(1, 5);
    }
    const Tween tween(keys);
    for (const KeyFrame& key : keys) RC_ASSERT(tween.at(key.time) == key.position);
    const double u = number(0, 1);
    const Point p = tween.at(std::lerp(keys[0].time, keys[1].time, u));
    const Vector way = keys[1].position - keys[0].position;
    RC_ASSERT((p - keys[0].position).cross(way).norm() <= 1e-12 * (1 + way.squaredNorm()));
  });
}

TEST_CASE("A bounce never goes below the floor, never gains energy, and loses it at impacts alone") {
  rc::prop("bounce", [] {
    const double g = number(1, 20);
    const Bounce bounce(number(0, 30), number(-60, 60), g, number(0, 1));
    const auto energy = [&](double t) {
      const double v = bounce.speed_down(t);
      return g * bounce.height(t) + v * v / 2;
    };
    const double a = number(0, 20), b = a + number(0, 20);
    RC_ASSERT(bounce.height(a) >= 0);
    RC_ASSERT(energy(b) <= energy(a) * (1 + 1e-12) + 1e-12);
    const auto between = [&](const std::vector<Landing>& list) {
      return std::any_of(list.begin(), list.end(),
                         [&](const Landing& l) { return l.time > a && l.time <= b; });
    };
    if (!between(bounce.impacts(b, 100000))) RC_ASSERT(energy(b) >= energy(a) * (1 - 1e-9) - 1e-9);
  });
}

TEST_CASE("The printed fall is never below the floor, and has a sample for each step") {
  rc::prop("printed bounce", [] {
    const PrintedBounce bounce{number(-60, 60),
                               number(0, 30),
                               number(0, 20),
                               number(0, 1) + 0.001,
                               *rc::gen::inRange<std::size_t>(1, 400),
                               number(0, 1)};
    const PrintedMotion motion = run(bounce);
    RC_ASSERT(motion.y.size() == bounce.samples);
    RC_ASSERT(motion.t.size() == bounce.samples);
    RC_ASSERT(*std::min_element(motion.y.begin(), motion.y.end()) >= 0);
    for (const PrintedHit& hit : motion.hits) RC_ASSERT(motion.y[hit.sample - 1] == 0);
  });
}

TEST_CASE(
    "A sweep along a curve is right to within its deviation: nothing touched before, something at the "
    "contact") {
  rc::prop("sweep along", [] {
    const Plane ground({0, 0, 1}, 0);
    std::vector<Point> points = some_points(*rc::gen::inRange<std::size_t>(2, 7));
    const double radius = number(0, 2), deviation = 0.01;
    points.front().z() = radius + number(1, 5);  // apart at the start
    const Curve curve = *rc::gen::arbitrary<bool>() ? Curve(Bezier(points)) : Curve(BSpline(points, 1));
    const auto contact = sweep_along(curve, radius, ground, deviation);
    const double until = contact ? contact->time : 1;
    for (int i = 0; i <= 200; ++i)
      RC_ASSERT(at(curve, until * i / 200).z() >= radius - deviation * (1 + 1e-9));
    if (contact) RC_ASSERT(at(curve, until).z() <= radius + deviation * (1 + 1e-9));
  });
}
