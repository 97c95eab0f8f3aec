#include "first_contact/sweep/sphere_box.hpp"

#include "catch.hpp"
#include "first_contact/geometry/transform.hpp"

using namespace first_contact;

namespace {

const Vector x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
const Box brick{{0, 0, 0}, 4 * x, 2 * y, 2 * z};

std::optional<Contact> cast(const Box& box, const Point& from, const Point& to, double radius) {
  return sweep(Moving{Sphere{from, radius}, to - from}, box);
}

}  // namespace

TEST_CASE("A sphere meets the face, the edge or the vertex of a box, whichever is first") {
  const auto face = cast(brick, {1.5, 0.5, 5}, {1.5, 0.5, 1}, 1);
  REQUIRE(face);
  CHECK(face->time == 0.75);
  CHECK(face->feature == Feature::face);
  CHECK(face->normal == z);
  CHECK(face->point() == Point(1.5, 0.5, 1));
  const auto edge = cast(brick, {2.6, 0.5, 5}, {2.6, 0.5, 1}, 1);
  REQUIRE(edge);
  CHECK(edge->time == Approx((5 - 1.8) / 4));
  CHECK(edge->feature == Feature::edge);
  CHECK((edge->normal - Vector(0.6, 0, 0.8)).norm() < 1e-15);
  const auto vertex = cast(brick, {2.48, 1.36, 5}, {2.48, 1.36, 1}, 1);
  REQUIRE(vertex);
  CHECK(vertex->feature == Feature::vertex);
  CHECK(vertex->point() == Point(2, 1, 1));
  CHECK_FALSE(cast(brick, {2.8, 1.8, 5}, {2.8, 1.8, -5}, 1));
}

TEST_CASE("The middle of a box's face is a face, along its diagonal as well") {
  for (const double across : {0.0, 0.5, 0.999}) {
    const auto contact = cast(brick, {2 * across, across, 5}, {2 * across, across, 0}, 0.5);
    REQUIRE(contact);
    CHECK(contact->feature == Feature::face);
    CHECK(contact->time == 0.7);
  }
}

TEST_CASE("A sphere that touches a box is in contact if it approaches, and not if it slides or leaves") {
  CHECK(cast(brick, {0, 0, 2}, {0, 0, 1}, 1)->time == 0);
  CHECK_FALSE(cast(brick, {0, 0, 2}, {9, 0, 2}, 1));
  CHECK_FALSE(cast(brick, {0, 0, 2}, {0, 1, 3}, 1));
  CHECK_FALSE(cast(brick, {0, 0, 2}, {0, 0, 2}, 1));
}

TEST_CASE("A sphere that overlaps a box can get out of it, and no deeper") {
  CHECK(cast(brick, {1, 0, 1.5}, {1, 0, 0}, 1)->time == 0);
  CHECK_FALSE(cast(brick, {1, 0, 1.5}, {1, 0, 4}, 1));
  const auto within =
      cast(brick, {1, 0, 0.75}, {1, 0.1, 0}, 0.125);  // its centre is in the box, near the top
  REQUIRE(within);
  CHECK(within->time == 0);
  CHECK(within->normal == z);
  CHECK(within->point() == Point(1, 0, 1));
  CHECK_FALSE(cast(brick, {1, 0, 0.75}, {1, 5, 0.76}, 0.125));
  CHECK_FALSE(cast(brick, {1, 0.75, 0.75}, {1, 0, 5}, 0.125));  // as near to the side: out of one is out
  CHECK(cast(brick, {1, 0.75, 0.75}, {1, 0, 0}, 0.125)->time == 0);
}

TEST_CASE("A sphere that overlaps a box's edge or vertex is judged along the way to it") {
  const auto edge = cast(brick, {2.25, 0, 1.25}, {0, 0, 1.25}, 1);
  REQUIRE(edge);
  CHECK(edge->feature == Feature::edge);
  CHECK((edge->normal - Vector(1, 0, 1).normalized()).norm() < 1e-15);
  CHECK(edge->point() == Point(2, 0, 1));
  CHECK_FALSE(cast(brick, {2.25, 0, 1.25}, {2.25, 9, 1.25}, 1));
  CHECK(cast(brick, {2.25, 1.25, 1.25}, {0, 0, 0}, 1)->feature == Feature::vertex);
}

TEST_CASE(
    "A sphere that overlaps an edge with a vertex in reach leaves along the edge, whichever its axis is, "
    "also of a rod") {
  const Box cube{{0, 0, 0}, 2 * x, 2 * y, 2 * z};
  for (const int axis : {0, 1, 2}) {
    const auto along = [axis](double a, double b, double c) {  // a along the axis
      const Vector v(a, b, c);
      return Vector(v[(3 - axis) % 3], v[(4 - axis) % 3], v[(5 - axis) % 3]);
    };
    const Sphere over_edge{along(0.8, 1.2, 1.2),
                           0.5};                       // .28 from the edge, .35 from the vertex where it ends
    const Sphere over_rod{along(0.8, 0.2, 0.2), 0.5};  // likewise
    const Vector end = along(2, 0, 0);
    const Box rod{{0, 0, 0}, end.cwiseProduct(x), end.cwiseProduct(y), end.cwiseProduct(z)};
    INFO("axis " << axis);
    for (const auto& [sphere, box] : {std::pair{over_edge, cube}, std::pair{over_rod, rod}}) {
      CHECK_FALSE(sweep(Moving{sphere, along(1, 0.05, 0.05)}, box));
      const auto deeper = sweep(Moving{sphere, along(1, -0.05, -0.05)}, box);
      REQUIRE(deeper);
      CHECK(deeper->feature == Feature::edge);
      CHECK(deeper->time == 0);
    }
  }
}
TEST_CASE("In the middle of a box the normal is against the motion") {
  const auto contact = cast(brick, {0, 0, 0}, {0, 0, -3}, 0.5);
  REQUIRE(contact);
  CHECK(contact->time == 0);
  CHECK(contact->normal == z);
}

TEST_CASE(
    "As near to two sides, and as steep on both, a sphere goes in by the side across the earlier axis") {
  const Box cube{{0, 0, 0}, 2 * x, 2 * y, 2 * z};
  CHECK(cast(cube, {0.5, 0.5, 0}, {0, 0, 0}, 0.125)->normal == x);
  CHECK(cast(cube, {0, 0.5, 0.5}, {0, 0, 0}, 0.125)->normal == y);
  CHECK(cast(cube, {0.5, 0.5, 0}, {0.25, 0, 0}, 0.125)->normal == y);  // steeper
}

TEST_CASE("A point is a sphere of radius 0: it meets the box itself") {
  const auto contact = sweep(Moving{Point(0.5, 0.25, 3), Vector(0, 0, -4)}, brick);
  REQUIRE(contact);
  CHECK(contact->time == 0.5);
  CHECK((contact->point() - Point(0.5, 0.25, 1)).norm() < 1e-15);
  CHECK(overlap(Point(2, 1, 1), brick));
  CHECK_FALSE(overlap(Point(2, 1, 1.25), brick));
  CHECK(sweep(Moving{Point(0, 0, 1), Vector(0, 0, -1)}, brick)->time == 0);
  CHECK_FALSE(sweep(Moving{Point(0, 0, 1), Vector(0, 0, 1)}, brick));
}

TEST_CASE("A flat box is a rectangle, a rod or a point") {
  const Box sheet{{0, 0, 0}, 4 * x, 2 * y, {0, 0, 0}}, rod{{0, 0, 0}, 4 * x, {0, 0, 0}, {0, 0, 0}};
  const Box speck{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  for (const Box& flat : {sheet, rod, speck}) {
    for (const double side : {1.0, -1.0}) {
      const auto contact = cast(flat, {0, 0, 3 * side}, {0, 0, -side}, 1);
      REQUIRE(contact);
      CHECK(contact->time == 0.5);
      CHECK(contact->normal == side * z);
      CHECK(contact->point().norm() < 1e-15);
    }
    const auto sunk = sweep(Moving{Point(0, 0, 0), Vector(0, 0, 2)}, flat);
    REQUIRE(sunk);
    CHECK(sunk->time == 0);
    CHECK(sunk->normal == -z);
  }
  CHECK(cast(sheet, {0, 0, 3}, {0, 0, -1}, 1)->feature == Feature::face);
  CHECK(cast(rod, {0, 0, 3}, {0, 0, -1}, 1)->feature == Feature::edge);
  CHECK(cast(speck, {0, 0, 3}, {0, 0, -1}, 1)->feature == Feature::vertex);
}

TEST_CASE("A sphere and a box touch at the same time whichever of them moves") {
  const Box turned = Rigid::turned(Vector(1, 2, 3), 0.7).box(brick);
  const Sphere ball{{1, 0.5, 6}, 0.75};
  const Vector fall(0.25, 0, -5);
  const auto one = sweep(Moving{ball, fall}, turned);
  const auto other = sweep(Moving{turned, Vector(-fall)}, ball);
  REQUIRE(one);
  REQUIRE(other);
  CHECK(other->time == one->time);
  CHECK(other->normal == -one->normal);
  CHECK(other->feature == one->feature);
  CHECK((other->point() - (ball.center + 0.75 * other->normal)).norm() < 1e-14);
}

TEST_CASE("A box far from the origin, large or small, is met at the same time") {
  const auto expected = cast(brick, {2.6, 0.5, 5}, {2.6, 0.5, 1}, 1)->time;
  for (const double scale : {0x1p-60, 1.0, 0x1p60}) {
    const Point far = scale * Point(0x1p20, -0x1p20, 0x1p19);
    const Box box{far, scale * brick.r, scale * brick.s, scale * brick.t};
    const Moving ball{Sphere{far + scale * Point(2.6, 0.5, 5), scale}, scale * Vector(0, 0, -4)};
    const auto contact = sweep(ball, box);
    REQUIRE(contact);
    CHECK(std::abs(contact->time - expected) < 1e-9);
    if (scale == 1) CHECK(contact->feature == Feature::edge);
  }
}
