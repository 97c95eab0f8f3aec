#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "anywhere.hpp"
#include "catch.hpp"
#include "digest/shapes.hpp"
#include "first_contact/batch/batch.hpp"
#include "first_contact/bvh/bvh.hpp"
#include "first_contact/geometry/closest_point.hpp"
#include "first_contact/geometry/fused.hpp"
#include "first_contact/motion/curve.hpp"
#include "first_contact/response/impact.hpp"
#include "first_contact/response/slide.hpp"
#include "first_contact/stage/hit_test.hpp"
#include "first_contact/sweep/box_box.hpp"
#include "first_contact/sweep/box_mesh.hpp"
#include "first_contact/sweep/box_plane.hpp"
#include "first_contact/sweep/ray_triangle.hpp"
#include "first_contact/sweep/sphere_box.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "first_contact/sweep/sphere_plane.hpp"
#include "first_contact/sweep/sphere_sphere.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"
#include "first_contact/sweep/turning_mesh.hpp"
#include "first_contact/trees/plain_bvh.hpp"

using namespace first_contact;
using namespace anywhere;
using digest::Dice;

namespace {

// The first contact, and what of it can be asked.
const auto swept = [](Record& record, const auto& mover, const auto& obstacle) {
  record.add(sweep(mover, obstacle));
};
const auto slid = [](Record& record, const auto& mover, const auto& obstacle) {
  const Slide path = slide(mover, obstacle);
  for (const Point& corner : path.positions) record.add(corner);
  for (const Contact& contact : path.contacts) record.add(contact);
};

template <class Surface>
std::uint64_t casts(const Mesh& mesh, std::uint64_t seed) {
  Dice dice(seed);
  const Surface surface(mesh);
  Record record(false);
  for (int i = 0; i < 20; ++i) record.add(sweep(digest::ball(dice, 1), surface));
  return record.hash();
}

std::uint64_t box_casts(const Mesh& mesh, std::uint64_t seed) {
  Dice dice(seed);
  const Environment surface(mesh);
  Record record(false);
  for (int i = 0; i < 5; ++i) record.add(sweep(Moving<Box>{digest::box(dice, 1), dice.vector()}, surface));
  return record.hash();
}

}  // namespace

TEST_CASE("A plane is the same wherever its three numbers lie in memory") {
  Dice dice(1);
  for (int i = 0; i < 2000; ++i) {
    const Vector normal = dice.vector();
    const double offset = dice.coordinate();
    CAPTURE(i, to_text(normal), offset);
    CHECK(same_everywhere(
        [&](Record& record, const Vector& n) { record.add(Plane(n, offset).coefficients()); }, normal));
    CHECK(same_everywhere([](Record& record, const Vector& v) { record.add(norm(v)); }, normal));
  }
}

TEST_CASE("A first contact is the same wherever the shapes lie in memory") {
  Dice dice(2);
  for (int i = 0; i < 500; ++i) {
    const Moving<Sphere> ball = digest::ball(dice, 1), other = digest::ball(dice, 1);
    const Plane plane = digest::plane(dice, 1);
    const Triangle triangle = digest::triangle(dice, 1);
    const Moving<Box> box{digest::box(dice, 1), dice.vector()};
    const Box solid = digest::box(dice, 1);
    CAPTURE(i);
    CHECK(same_everywhere(swept, ball, plane));
    CHECK(same_everywhere(swept, ball, other));
    CHECK(same_everywhere(swept, ball, other.shape));
    CHECK(same_everywhere(swept, ball, triangle));
    CHECK(same_everywhere(swept, Moving<Point>{ball.shape.center, ball.displacement}, triangle));
    CHECK(same_everywhere(swept, ball, solid));
    CHECK(same_everywhere(swept, Moving<Point>{ball.shape.center, ball.displacement}, solid));
    CHECK(same_everywhere(swept, box, plane));
    CHECK(same_everywhere(swept, box, other.shape));
    CHECK(same_everywhere(swept, box, solid));
    CHECK(same_everywhere(swept, box, triangle));
    CHECK(same_everywhere(slid, ball, plane));
    CHECK(same_everywhere(slid, ball, triangle));
  }
}

TEST_CASE("A first contact with a surface is the same wherever its vertices lie in memory") {
  Dice dice(3);
  for (std::uint64_t i = 0; i < 20; ++i) {
    const Mesh mesh = digest::ground(dice, 3, 1);
    for (std::uint32_t unused = 1; unused < 8; ++unused) {
      CAPTURE(i, unused);
      CHECK(casts<Environment>(moved_in_memory(mesh, unused), i) == casts<Environment>(mesh, i));
      CHECK(casts<Bvh>(moved_in_memory(mesh, unused), i) == casts<Environment>(mesh, i));
      CHECK(casts<PlainBvh>(moved_in_memory(mesh, unused), i) == casts<Environment>(mesh, i));
      CHECK(box_casts(moved_in_memory(mesh, unused), i) == box_casts(mesh, i));
    }
  }
}

TEST_CASE("A mesh that turns touches at the same time wherever its axis and its vertices lie in memory") {
  Dice dice(4);
  const Mesh floor = digest::ground(dice, 1, 1);
  for (int i = 0; i < 10; ++i) {
    const Point a = dice.point(), b = dice.point(), c = dice.point();
    const Mesh wing({a, b, c}, {{0, 1, 2}});
    const Vector axis = dice.vector();
    const auto ask = [&](Record& record, const Vector& direction) {
      for (std::uint32_t unused = 0; unused < 4; ++unused)
        record.add(sweep(Turning<Mesh>(moved_in_memory(wing, unused), {0, 0, 3}, direction, 2), floor));
    };
    CAPTURE(i);
    CHECK(same_everywhere(ask, axis));
  }
}

TEST_CASE("Curves, impacts, distances and hit tests are the same wherever their numbers lie in memory") {
  Dice dice(5);
  for (int i = 0; i < 200; ++i) {
    const Vector2 u = dice.vector().head<2>(), v = dice.vector().head<2>(), n(1, 2);
    const Point a = dice.point(), b = dice.point(), p = dice.point();
    const Triangle triangle = digest::triangle(dice, 1);
    CAPTURE(i);
    CHECK(same_everywhere(
        [&](Record& record, const Vector2& x, const Vector2& y) {
          record.add(impact(Body<2>(1, x), Body<2>(3, y), n, 0.75).velocity_p);
        },
        u, v));
    CHECK(same_everywhere(
        [](Record& record, const Point& x, const Point& y) {
          record.add(Bezier({x, y, x}).at(0.3));
        },
        a, b));
    CHECK(same_everywhere(
        [](Record& record, const Point& x, const Triangle& t) { record.add(closest_point(x, t)); }, p,
        triangle));
    CHECK(same_everywhere(
        [&](Record& record, const Vector2& x, const Vector2& y) {
          const StageObject object(std::vector<Point2>{x, y, n});
          record.add(hit_test_point(object, 0.5 * (x + y), true));
        },
        u, v));
  }
}

TEST_CASE("A batch is the same wherever its columns begin") {
  Dice dice(6);
  std::vector<double> numbers;
  for (int i = 0; i < 8 * 64; ++i) numbers.push_back(dice.part());
  const auto times_at = [&](std::size_t start) {
    std::vector<double> moved(start);
    moved.insert(moved.end(), numbers.begin(), numbers.end());
    const auto column = [&](std::size_t k) { return std::span(moved).subspan(start + k * 64, 63); };
    const Columns center{column(0), column(1), column(2)}, way{column(3), column(4), column(5)};
    std::vector<double> times(63);
    sweep(MovingSpheres(center, column(6), way), Plane({1, 2, 3}, -2), times);
    return times;
  };
  for (std::size_t start = 1; start < 8; ++start) CHECK(times_at(start) == times_at(0));
}

TEST_CASE("A product and a sum from additions and products alone is that of the processor, rounded once") {
  Dice dice(7);
  for (int i = 0; i < 200000; ++i) {
    const double a = std::ldexp(dice.part(), dice.whole(-40, 40)),
                 b = std::ldexp(dice.part(), dice.whole(-40, 40));
    const double near = dice.one_in(2) ? -a * b * (1 + dice.whole(-3, 3) * 0x1p-52) : dice.coordinate();
    const double c = dice.one_in(4) ? std::ldexp(near, dice.whole(-110, 110)) : near;
    CAPTURE(i, a, b, c);
    REQUIRE(fused_in_software(a, b, c) == std::fma(a, b, c));
  }
}

TEST_CASE("A length is exact in its scale, from the smallest number to the largest") {
  const Vector v(2, -3, 6);  // of length 7
  for (const int exponent : {-1074, -1022, -500, 0, 500, 1000, 1020}) {
    const Vector scaled(std::ldexp(2.0, exponent), std::ldexp(-3.0, exponent), std::ldexp(6.0, exponent));
    CAPTURE(exponent);
    CHECK(norm(scaled) == std::ldexp(7.0, exponent));
    CHECK(normalized(scaled) == Vector(v / 7));
  }
  CHECK(norm(Vector::Zero()) == 0);
  CHECK(normalized(Vector::Zero()) == Vector::Zero());
  CHECK(std::isnan(norm({0, std::nan(""), 1})));
  CHECK(norm({0, -HUGE_VAL, 1}) == HUGE_VAL);
}
