#include "first_contact/sweep/turning_plane.hpp"

#include <cmath>
#include <numbers>

#include "catch.hpp"
#include "first_contact/geometry/transform.hpp"

using namespace first_contact;

namespace {

constexpr double pi = std::numbers::pi;
const Plane ground{{0, 0, 1}, 0};

// 2 wide, 1 high, with its lower edge x = 0 on the ground, leaning by an angle about that edge.
Box leaning(double angle) {
  return Rigid::turned({0, 1, 0}, -angle).box({{1, 0, 0.5}, {2, 0, 0}, {0, 4, 0}, {0, 0, 1}});
}

}  // namespace

TEST_CASE("A box that leans falls back onto its face: about its edge, by the angle by which it leans") {
  for (const double lean : {0.1, 0.5, 1.2}) {
    CAPTURE(lean);
    const auto contact = sweep(Turning<Box>(leaning(lean), {0, 0, 0}, {0, 1, 0}, pi / 2), ground);
    REQUIRE(contact);
    const double angle = contact->time * pi / 2, gap = turning_gap * 4;
    CHECK(angle <= lean);
    CHECK(angle >= lean - 2 * gap);  // the far edge comes down by 2 a radian
    CHECK(contact->feature == Feature::face);
    CHECK(contact->points.cols() == 4);
    CHECK(contact->normal == Vector(0, 0, 1));
    for (const auto& point : contact->points.colwise()) CHECK(point.z() == 0);
  }
}

TEST_CASE("A box that stands on an edge and tips over lands on its other face after a quarter turn") {
  const Box box = leaning(0);
  const auto other_way = sweep(Turning<Box>(box, {0, 0, 0}, {0, -1, 0}, pi), ground);
  REQUIRE(other_way);
  CHECK(other_way->time * pi <= pi / 2);
  CHECK(other_way->time * pi == Approx(pi / 2).margin(1e-6));
}

TEST_CASE("A corner comes first where a box is tilted, and an edge where it rolls") {
  const Box tilted = Rigid::turned({1, 0.3, 0}, 0.4).box({{0, 0, 3}, {1, 0, 0}, {0, 2, 0}, {0, 0, 1}});
  const auto corner = sweep(Turning<Box>(tilted, tilted.center, {0, 1, 0}, 0.2, {0, 0, -4}), ground);
  REQUIRE(corner);
  CHECK(corner->feature == Feature::vertex);
  const Box level{{0, 0, 3}, {1, 0, 0}, {0, 2, 0}, {0, 0, 1}};
  const auto edge = sweep(Turning<Box>(level, level.center, {0, 1, 0}, 0.2, {0, 0, -4}), ground);
  REQUIRE(edge);
  CHECK(edge->feature == Feature::edge);
}

TEST_CASE("Without a turn a box lands when the straight sweep says so") {
  const Box box = Rigid::turned({1, 2, 3}, 0.7).box({{0, 0, 3}, {1, 0, 0}, {0, 2, 0}, {0, 0, 1}});
  const auto contact = sweep(Turning<Box>(box, {0, 0, 0}, {0, 0, 1}, 0, {1, 2, -4}), ground);
  REQUIRE(contact);
  const double reach = box.effective_radius({0, 0, 1}), exact = (box.center.z() - reach) / 4;
  CHECK(contact->time <= exact);
  CHECK(contact->time >= exact - turning_gap * 5 / 4);
}

TEST_CASE("What slides along the plane, turns on it or leaves it meets nothing") {
  const Box flat{{0, 0, 0.5}, {2, 0, 0}, {0, 4, 0}, {0, 0, 1}};
  CHECK_FALSE(sweep(Turning<Box>(flat, {0, 0, 0}, {0, 0, 1}, 2, {3, 1, 0}), ground));
  CHECK_FALSE(sweep(Turning<Box>(flat, {0, 0, 0}, {0, 0, 1}, 0, {0, 0, 2}), ground));
  CHECK_FALSE(sweep(Turning<Box>(flat, {0, 0, 0}, {0, 0, 1}, 0), ground));
  CHECK(sweep(Turning<Box>(flat, {0, 0, 0}, {0, 0, 1}, 0, {0, 0, -1}), ground)->time == 0);
}

TEST_CASE(
    "The surface of a box has twelve triangles that look outward, also of one whose axes are left-handed") {
  for (const double sign : {1.0, -1.0}) {
    const Box box{{1, 2, 3}, {2, 0, 0}, {0, 4, 0}, {0, 0, sign * 1}};
    const Mesh mesh = surface_of(box);
    CHECK(mesh.size() == 12);
    double volume = 0;
    for (const Triangle& t : mesh.triangles()) {
      CHECK(t.area_vector().dot(t.a - box.center) > 0);
      volume += t.area_vector().dot(t.a - box.center) / 3;
    }
    CHECK(std::abs(volume) == Approx(volume));
  }
}
