// The range of numbers that contact.hpp promises, at its ends: what moves, bounces and is struck.
#include "first_contact/motion/bounce.hpp"
#include "first_contact/motion/sweep_tween.hpp"
#include "first_contact/response/impact.hpp"
#include "first_contact/response/slide.hpp"
#include "first_contact/sweep/sphere_box.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "first_contact/sweep/sphere_plane.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"
#include "property/in_units.hpp"

using namespace first_contact;
using namespace in_units;

namespace {

void check_scaled_slide(const Slide& answer, const Slide& at_size_1, int power) {
  REQUIRE(answer.ending == at_size_1.ending);
  REQUIRE(answer.positions.size() == at_size_1.positions.size());
  for (std::size_t k = 0; k < answer.positions.size(); ++k)
    check_scaled(answer.positions[k], at_size_1.positions[k], power);
  REQUIRE(answer.contacts.size() == at_size_1.contacts.size());
  for (std::size_t k = 0; k < answer.contacts.size(); ++k)
    check_scaled(std::optional(answer.contacts[k]), std::optional(at_size_1.contacts[k]), power);
}

void check_slide(const Moving<Sphere>& ball, const auto& obstacle) {
  const Slide at_size_1 = slide(ball, obstacle);
  for (const int power : powers) {
    CAPTURE(power);
    check_scaled_slide(slide(times(ball, power), times(obstacle, power)), at_size_1, power);
  }
}

std::vector<Point> points(Scene& scene, int count) {
  std::vector<Point> all;
  for (int i = 0; i < count; ++i) all.push_back(scene.vector(3));
  return all;
}

Curve curve_of(const std::vector<Point>& points, bool spline) {
  return spline ? Curve(BSpline(points, 2)) : Curve(Bezier(points));
}

}  // namespace

TEST_CASE("A slide goes the same way in every unit") {
  in_every_unit(1307, 60, [](Scene& scene) {
    const Moving<Sphere> ball = scene.ball();
    check_slide(ball, Plane({0, 0.5, 2}, scene.number(-1, 1)));
    check_slide(ball, scene.triangle());
    check_slide(ball, scene.box());
    const Mesh mesh = scene.mesh();
    const Slide path = slide(ball, Environment(mesh));
    for (const int power : powers) {
      CAPTURE(power);
      check_scaled_slide(slide(times(ball, power), Environment(times(mesh, power))), path, power);
    }
  });
}

TEST_CASE("A way along a curve meets the same thing in every unit") {
  int hits = 0;
  in_every_unit(1315, 60, [&](Scene& scene) {
    const Mesh mesh = scene.mesh();
    const std::vector<Point> some = points(scene, 4);
    const bool spline = scene.chance().pick(2) == 1;
    const auto along = [&](int power) {
      return sweep_along(curve_of(times(some, power), spline), times(0.25, power),
                         Environment(times(mesh, power)), times(0.125, power));
    };
    const auto at_size_1 = along(0);
    hits += at_size_1.has_value();
    for (const int power : powers) {
      CAPTURE(power);
      check_scaled(along(power), at_size_1, power);
    }
  });
  CHECK(hits > 20);
}

TEST_CASE("A curve, its slope and its length are the same in every unit") {
  in_every_unit(1316, 100, [](Scene& scene) {
    const std::vector<Point> some = points(scene, 5);
    const bool spline = scene.chance().pick(2) == 1;
    const double u = scene.number(-0.25, 1.25);
    const Curve curve = curve_of(some, spline);
    const ArcLength length(curve);
    for (const int power : powers) {
      CAPTURE(power);
      const Curve large = curve_of(times(some, power), spline);
      check_scaled(at(large, u), at(curve, u), power);
      if (power < 990) check_scaled(at(derivative(large), u), at(derivative(curve), u), power);
      const ArcLength large_length(large);
      check_scaled(large_length.total(), length.total(), power);
      check_scaled(large_length.to(u), length.to(u), power);
      check_scaled(large_length.at(u), length.at(u), power);
      REQUIRE(large_length.parameter(times(length.total() / 3, power)) ==
              length.parameter(length.total() / 3));
    }
  });
}

TEST_CASE("A tween is at the same place in every unit of length, and of time") {
  in_every_unit(1317, 60, [](Scene& scene) {
    const std::vector<Point> places = points(scene, 3), between = points(scene, 2);
    const Easing easing = ease::all()[scene.chance().pick(ease::all().size())].easing;
    const double moment = scene.number(-1, 3);
    const auto tween = [&](int power, int pace) {
      return Tween(
          {{times(-0.5, pace), times(places[0], power), easing},
           {times(1, pace), times(places[1], power), easing, Path::bezier(times(between, power), true)},
           {times(2, pace), times(places[2], power)}});
    };
    const Point at_size_1 = tween(0, 0).at(moment);
    for (const int power : powers)
      for (const int pace : {-1000, 0, 1000}) {
        CAPTURE(power, pace);
        check_scaled(tween(power, pace).at(times(moment, pace)), at_size_1, power);
      }
  });
}

TEST_CASE("A tween meets the same thing in every unit of length, and of time") {
  int hits = 0;
  in_every_unit(1319, 40, [&](Scene& scene) {
    const Mesh mesh = scene.mesh();
    const std::vector<Point> places = points(scene, 2), between = points(scene, 2);
    const Easing easing = ease::all()[scene.chance().pick(ease::all().size())].easing;
    const bool by_length = scene.chance().pick(2) == 1;
    const auto touch = [&](int power, int pace) {
      const Tween tween({{times(-0.5, pace), times(places[0], power), easing,
                          Path::bezier(times(between, power), by_length)},
                         {times(1, pace), times(places[1], power)}});
      auto contact = sweep(tween, times(0.25, power), Environment(times(mesh, power)));
      if (contact) contact->time = times(contact->time, -pace);
      return contact;
    };
    const auto at_size_1 = touch(0, 0);
    hits += at_size_1.has_value();
    for (const int power : powers)
      for (const int pace : {-1000, 0, 1000}) {
        CAPTURE(power, pace);
        check_scaled(touch(power, pace), at_size_1, power);
      }
  });
  CHECK(hits > 15);
}

TEST_CASE("A bounce is the same in every unit of length, and of time") {
  in_every_unit(1318, 100, [](Scene& scene) {
    const double height = scene.number(0, 4), speed = scene.number(-4, 4), gravity = scene.number(0.01, 4);
    const double restitution = scene.chance().pick(4) ? scene.number(0, 1) : 1, moment = scene.number(0, 8);
    const Bounce at_size_1(height, speed, gravity, restitution);
    for (const int power : {-890, -300, 0, 300, 900, 990})
      for (const int pace : {-40, 0, 40}) {
        if (power - 2 * pace > 990) continue;  // no such gravity
        CAPTURE(power, pace);
        const Bounce now(times(height, power), times(speed, power - pace), times(gravity, power - 2 * pace),
                         restitution);
        for (const std::size_t n : {1U, 2U, 7U}) {
          const auto landing = now.impact(n), expected = at_size_1.impact(n);
          REQUIRE(landing.has_value() == expected.has_value());
          if (!landing) continue;
          REQUIRE(landing->time == times(expected->time, pace));
          REQUIRE(landing->speed == times(expected->speed, power - pace));
        }
        for (const std::size_t n : {0U, 1U, 5U}) {
          const auto top = now.apex(n), expected = at_size_1.apex(n);
          REQUIRE(top.has_value() == expected.has_value());
          if (top) REQUIRE(top->height == times(expected->height, power));
        }
        REQUIRE(now.rest_time().has_value() == at_size_1.rest_time().has_value());
        if (now.rest_time()) REQUIRE(*now.rest_time() == times(*at_size_1.rest_time(), pace));
        REQUIRE(now.height(times(moment, pace)) == times(at_size_1.height(moment), power));
        REQUIRE(now.speed_down(times(moment, pace)) == times(at_size_1.speed_down(moment), power - pace));
      }
  });
}

TEST_CASE("An impact is the same in every unit of speed and of mass, and however long its normal") {
  in_every_unit(1319, 200, [](Scene& scene) {
    const Vector p = scene.vector(4), q = scene.vector(4), normal = scene.vector(1) + Vector(0, 0, 2);
    const double mass_p = scene.number(0.1, 4), mass_q = scene.number(0.1, 4), e = scene.number(0, 1);
    const auto after = impact(Body<3>(mass_p, p), Body<3>(mass_q, q), normal, e);
    for (const int speed : {-1000, -500, 0, 500, 1000})
      for (const int mass : {-1000, 0, 1000})
        for (const int length : {-1000, 0, 1000}) {
          if (std::abs(speed + mass) > 1000) continue;  // the impulse would be no double
          CAPTURE(speed, mass, length);
          const auto now = impact(Body<3>(times(mass_p, mass), times(p, speed)),
                                  Body<3>(times(mass_q, mass), times(q, speed)), times(normal, length), e);
          check_scaled(now.velocity_p, after.velocity_p, speed);
          check_scaled(now.velocity_q, after.velocity_q, speed);
          check_scaled(now.impulse, after.impulse, speed + mass);
        }
  });
}
