#include "first_contact/sweep/box_plane.hpp"

#include <cmath>
#include <random>

#include "catch.hpp"
#include "first_contact/geometry/transform.hpp"

using namespace first_contact;

namespace {

const Plane floor_plane{{0, 0, 2}, 0};  // not of unit length on purpose
const Vector x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
constexpr double epsilon = std::numeric_limits<double>::epsilon();

Box brick_at(const Point& center) { return {center, {6, 0, 0}, {0, 4, 0}, {0, 0, 2}}; }

// A brick of height 2 that moves straight up or down.
std::optional<Contact> drop(double from, double to) {
  return sweep(Moving{brick_at({5, 6, from}), {0, 0, to - from}}, floor_plane);
}

// A box that is turned first and then falls from height 10 to height 0.
Contact landing(const Vector& size, const Rigid& turn) {
  const Box box = turn.box({{0, 0, 0}, size.x() * x, size.y() * y, size.z() * z});
  const auto contact = sweep(Moving{Rigid::moved_by({1, 2, 10}).box(box), {0, 0, -10}}, floor_plane);
  REQUIRE(contact);
  return *contact;
}

bool holds(const ContactPoints& points, const Point& p) {
  return (points.colwise() - p).colwise().norm().minCoeff() < 1e-12;
}

const Rigid upright;
const Rigid on_edge = Rigid::turned(y, 0.5);
const Rigid on_vertex = Rigid::turned(x, 0.7).after(Rigid::turned(y, 0.5));

struct Dice {
  explicit Dice(unsigned seed) : engine(seed) {}
  double operator()(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  }
  Vector vector() { return {(*this)(-1, 1), (*this)(-1, 1), (*this)(-1, 1)}; }
  Rigid turn() { return Rigid::turned(vector(), (*this)(-4, 4)); }
  std::mt19937 engine;
};

}  // namespace

TEST_CASE("A box meets a plane when its centre is one effective radius away") {
  const auto contact = drop(3, -1);
  REQUIRE(contact);
  CHECK(contact->time == 0.5);
  CHECK(contact->normal == z);
  CHECK(contact->point() == Point(5, 6, 0));
}

// Where it lands.

TEST_CASE("A box that lies level lands on a face: four points, in order around it") {
  const Contact contact = *drop(3, -1);
  CHECK(contact.feature == Feature::face);
  REQUIRE(contact.points.cols() == 4);
  for (const Point& corner : {Point(2, 4, 0), Point(8, 4, 0), Point(8, 8, 0), Point(2, 8, 0)})
    CHECK(holds(contact.points, corner));
  for (int i = 0; i < 4; ++i) {  // neighbours share a side, and are no diagonal apart
    const double side = (contact.points.col(i) - contact.points.col((i + 1) % 4)).norm();
    CHECK((side == 6 || side == 4));
  }
}
TEST_CASE("A box turned about one of its axes lands on an edge: the two ends of it") {
  const Contact contact = landing({6, 4, 2}, on_edge);
  CHECK(contact.feature == Feature::edge);
  REQUIRE(contact.points.cols() == 2);
  CHECK((contact.points.col(1) - contact.points.col(0)).isApprox(4 * y));
}
TEST_CASE("A box turned about two axes lands on a vertex") {
  const Contact contact = landing({6, 4, 2}, on_vertex);
  CHECK(contact.feature == Feature::vertex);
  CHECK(contact.points.cols() == 1);
}
TEST_CASE("The vertex that lands is the lowest of the eight, for each of the eight") {
  for (int i = 0; i < 8; ++i) {
    const Vector n = Vector((i & 1) ? 1 : -1, (i & 2) ? 2 : -2, (i & 4) ? 3 : -3).normalized();
    const Box box = brick_at({0, 0, 0});
    const ContactPoints lowest = lowest_vertices(box, n);
    REQUIRE(lowest.cols() == 1);
    for (const Point& vertex : box.vertices()) CHECK(n.dot(lowest.col(0)) <= n.dot(vertex));
  }
}
TEST_CASE(
    "With one common sign, as the paper prints its general vertex, the wrong one is taken for the lowest") {
  const Vector n = Vector(1, -2, 3).normalized();  // the signs of R.N, S.N and T.N differ
  const Box box = brick_at({0, 0, 0});
  const Vector half = 0.5 * (box.r + box.s + box.t);
  const double as_printed = std::min(n.dot(half), n.dot(-half));
  const double corrected = n.dot(lowest_vertices(box, n).col(0));
  CHECK(corrected == Approx(-box.effective_radius(n)));
  CHECK(as_printed > corrected + 1);
}
TEST_CASE("What touches is level: an edge and a face have all their points on the plane") {
  Dice dice(11);
  for (int i = 0; i < 1000; ++i) {
    const Rigid turn = dice.turn();
    const Plane slope = turn.plane(floor_plane);
    const Box box = turn.box(brick_at({1, 2, 7}));
    const auto contact = sweep(Moving{box, turn.direction({1, 2, -8})}, slope);
    REQUIRE(contact);
    for (const auto& p : contact->points.colwise()) CHECK(std::abs(slope.signed_distance(p)) < 1e-14);
  }
}
TEST_CASE("A flat box lands on what it has: a rectangle on a corner, a side or its face") {
  const Contact flat = landing({6, 4, 0}, upright);
  CHECK(flat.feature == Feature::face);
  CHECK(flat.points.cols() == 4);
  CHECK(landing({6, 4, 0}, on_edge).feature == Feature::edge);
  CHECK(landing({6, 4, 0}, on_vertex).feature == Feature::vertex);
  CHECK(landing({6, 0, 2}, Rigid::turned(x, 0.3)).feature == Feature::edge);
}
TEST_CASE("A rod lands on an end or along its length, a point on itself") {
  CHECK(landing({6, 0, 0}, upright).feature == Feature::edge);
  CHECK(landing({6, 0, 0}, on_edge).feature == Feature::vertex);
  const Contact point = landing({0, 0, 0}, on_vertex);
  CHECK(point.feature == Feature::vertex);
  CHECK(point.points.cols() == 1);
  CHECK(point.time == 1);
}

// The tolerance of "parallel".

TEST_CASE("However a level box and its plane are turned together, it lands on its face, or on its edge") {
  const unsigned seed = 12;
  CAPTURE(seed);
  Dice dice(seed);
  double steepest = 0;
  for (int i = 0; i < 100000; ++i) {
    const Rigid turn = dice.turn();
    const Vector n = turn.plane({z, 0}).normal();
    const Box face = turn.box(brick_at({0, 0, 0}));
    const Box edge = turn.box(on_edge.box(brick_at({0, 0, 0})));
    for (const Vector& axis : {face.r, face.s, edge.s})
      steepest = std::max(steepest, std::abs(axis.dot(n)) / axis.norm());
    if (lowest_vertices(face, n).cols() != 4) FAIL("no face at turn " << i);
    if (lowest_vertices(edge, n).cols() != 2) FAIL("no edge at turn " << i);
  }
  INFO("steepest axis found: " << steepest / epsilon << " eps, of " << parallel_tolerance / epsilon);
  CHECK(steepest > epsilon);  // an exact zero, as in the paper, would not do
  CHECK(steepest < parallel_tolerance);
}
TEST_CASE("A tilt of two tolerances is seen, however the box is turned") {
  const unsigned seed = 13;
  CAPTURE(seed);
  Dice dice(seed);
  const double tilt = 2 * parallel_tolerance;
  for (int i = 0; i < 100000; ++i) {
    const Rigid turn = dice.turn();
    const Vector n = turn.plane({Vector(tilt, 0, 1), 0}).normal();
    if (lowest_vertices(turn.box(brick_at({0, 0, 0})), n).cols() != 2) FAIL("tilt not seen at turn " << i);
  }
}
TEST_CASE("Whether an axis is parallel does not depend on its length") {
  for (const double length : {1e-300, 1e-9, 1.0, 1e9, 1e300}) {
    CAPTURE(length);
    const Box box{{0, 0, 0}, length * x, 2 * y, 3 * z};
    CHECK(lowest_vertices(box, Vector(parallel_tolerance / 2, 0, 1)).cols() == 4);
    CHECK(lowest_vertices(box, Vector(parallel_tolerance * 2, 0, 1)).cols() == 2);
  }
}

// The contract of a sweep, clause by clause.

TEST_CASE("A box that ends short of the plane does not meet it") { CHECK_FALSE(drop(3, 1.25)); }
TEST_CASE("A box that arrives exactly at the end of its motion meets the plane at t = 1") {
  CHECK(drop(3, 1)->time == 1);
}
TEST_CASE("A box touching a plane and approaching has a contact at once") { CHECK(drop(1, 0)->time == 0); }
TEST_CASE("A box touching a plane and leaving has no contact") { CHECK_FALSE(drop(1, 2)); }
TEST_CASE("A box touching a plane and sliding along has no contact") {
  CHECK_FALSE(sweep(Moving{brick_at({0, 0, 1}), {5, 0, 0}}, floor_plane));
}
TEST_CASE("A box overlapping a plane and going deeper has a contact at once") {
  CHECK(drop(0.5, 0)->time == 0);
}
TEST_CASE("A box overlapping a plane and leaving has no contact, so that it can get out") {
  CHECK_FALSE(drop(0.5, 2));
}
TEST_CASE("The points of an overlapping box are on the plane, above or below the vertices and not as deep") {
  // A vertex 0.2 under the floor: the point is at 0, neither at -0.2 nor, doubled, at -0.4.
  const Contact contact = *drop(0.8, 0);
  CHECK(contact.points.row(2).isZero(0));
  CHECK(holds(contact.points, {8, 8, 0}));
}
TEST_CASE("A box at rest has no contact, overlapping or not") {
  CHECK_FALSE(drop(0.5, 0.5));
  CHECK_FALSE(drop(1, 1));
  CHECK_FALSE(drop(0, 0));
}
TEST_CASE(
    "A plane has two sides: a box from below has the normal pointing down, and lands on its upper face") {
  const auto contact = drop(-3, 1);
  REQUIRE(contact);
  CHECK(contact->time == 0.5);
  CHECK(contact->normal == -z);
  CHECK(contact->feature == Feature::face);
  CHECK(contact->points.row(2).isZero(0));
}
TEST_CASE("A box whose centre is on the plane has its normal against the motion") {
  CHECK(drop(0, -1)->normal == z);
  CHECK(drop(0, 1)->normal == -z);
  CHECK(drop(0, 1)->time == 0);
}
TEST_CASE("Box and plane overlap from touching on, on both sides") {
  CHECK(overlap(brick_at({7, 0, 1}), floor_plane));
  CHECK(overlap(brick_at({7, 0, -0.5}), floor_plane));
  CHECK_FALSE(overlap(brick_at({7, 0, -1.5}), floor_plane));
}
TEST_CASE("A motion of a box that is not finite is refused when it is made") {
  CHECK_THROWS_AS(Moving(brick_at({0, 0, 1}), Vector(0, std::nan(""), 0)), std::invalid_argument);
}
TEST_CASE("A sweep of the largest and the smallest boxes does not throw") {
  const Plane slope{{1, 1, 1}, 0};
  for (const double size : {5e-324, 1e-310, 1e-200, 1e200, 1e300}) {
    CAPTURE(size);
    const Box box{size * Vector(1, 1, 1), size * x, size * y, size * z};
    CHECK_NOTHROW(sweep(Moving{box, Vector(size * Vector(-1, -1, -1))}, slope));
    CHECK_NOTHROW(overlap(box, slope));
  }
}
TEST_CASE("A scene that is scaled by a power of two gives the bitwise scaled answer") {
  Dice dice(14);
  for (int i = 0; i < 300; ++i) {
    const Box box = dice.turn().box({3 * dice.vector(), dice(0, 2) * x, dice(0, 2) * y, dice(0, 2) * z});
    const Vector n = dice.vector(), v = 9 * dice.vector();
    const auto here = sweep(Moving{box, v}, Plane(n, 0.5));
    for (const int power : {-500, -40, 3, 500}) {
      const double scale = std::ldexp(1.0, power);
      const Box scaled{scale * box.center, scale * box.r, scale * box.s, scale * box.t};
      const auto there = sweep(Moving{scaled, Vector(scale * v)}, Plane(n, 0.5 * scale));
      CAPTURE(i, power);
      REQUIRE(here.has_value() == there.has_value());
      if (!here) continue;
      CHECK(here->time == there->time);
      CHECK(here->normal == there->normal);
      CHECK(here->feature == there->feature);
      CHECK(scale * here->points == there->points);
    }
  }
}

// Published mistakes of engines, as numbers: the plane is N.Q = offset.

namespace {

struct PublishedBox {
  const char* source;
  double half;
  Point start;
  Vector displacement, normal;
  double offset;
  std::optional<double> time;
};

const PublishedBox published_boxes[] = {
    // A gap of 6e-8 and a motion along the floor: the engine stopped on a normal (0, 0).
    {"erincatto/box2d#917", 0.05, {0.5, 0.050000059604644806, 0}, {1, 0, 0}, {0, 1, 0}, 0, {}},
    // A gap of 0.25 far from the origin: no collision was reported.
    {"godotengine/godot#103123", 10, {8000, 7989.75, 0}, {0, 1, 0}, {0, -1, 0}, -8000, 0.25},
    // An overlap by 0.05 at the start: its normal, against the motion, was taken for a back face's.
    {"jrouwe/JoltPhysics#2049",
     0.5,
     {0.009999999776482582, 0.949999988079071, 0},
     {0, -0.5, 0},
     {0, 1, 0},
     0.5,
     0.0},
    // At rest, 0.1 apart: the time of impact was said to be 0.
    {"dimforge/ncollide#141", 0.5, {0, 1.1, 0}, {0, 0, 0}, {0, 1, 0}, 0.5, {}},
    // Nine from the wall and ten to go: no impact was found.
    {"dimforge/ncollide#214", 1, {0, 0, 0}, {10, 0, 0}, {-1, 0, 0}, -9, 0.8},
    // Exactly three apart: 2.9975 was the engine's answer.
    {"NVIDIAGameWorks/PhysX#610", 1, {0, 15, 0}, {0, -10, 0}, {0, 1, 0}, 11, 0.3},
};

}  // namespace

TEST_CASE("Boxes that engines were reported to miss are met, or not, at the right time") {
  for (const PublishedBox& c : published_boxes) {
    CAPTURE(c.source);
    const Box box{c.start, 2 * c.half * x, 2 * c.half * y, 2 * c.half * z};
    const auto contact = sweep(Moving{box, c.displacement}, Plane(c.normal, -c.offset));
    REQUIRE(contact.has_value() == c.time.has_value());
    if (!contact) continue;
    CHECK(contact->time == *c.time);
    CHECK(contact->normal == c.normal);
    CHECK(contact->feature == Feature::face);
  }
}
