#include "first_contact/response/slide.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "catch.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "first_contact/sweep/sphere_plane.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"
#include "room.hpp"

using namespace first_contact;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
const Plane ground{{0, 0, 1}, 0};
const Plane wall_x{{-1, 0, 0}, 5};  // x = 5
const Plane wall_y{{0, -1, 0}, 5};  // y = 5

Slide roll(const Point& from, const Vector& by, const Room& room, double radius = 1) {
  return slide(Moving<Sphere>{{from, radius}, by}, room);
}

/// Two upright walls that meet in the line x = y = 0 and open towards +x, each `half_angle` from it.
Room wedge(double degrees) {
  const double half = degrees / 2 * std::numbers::pi / 180;
  return {{Plane({std::sin(half), -std::cos(half), 0}, 0), Plane({std::sin(half), std::cos(half), 0}, 0)}};
}

bool near(const Point& a, const Point& b, double tolerance = 1e-12) { return (a - b).norm() <= tolerance; }

}  // namespace

TEST_CASE("The paper's formula: P3 is the foot of the perpendicular from P2 to the wall through Q") {
  const Vector n(0, 0, 1);
  CHECK(slide_target({4, 2, -3}, {1, 0.5, 1}, n) == Point(4, 2, 1));
  const Vector m = Vector(1, 2, 2) / 3;
  const Point p3 = slide_target({4, 2, -3}, {1, 0.5, 1}, m);
  CHECK(std::abs((p3 - Point(1, 0.5, 1)).dot(m)) < 4 * epsilon);  // P3 is on the wall
  CHECK((p3 - Point(4, 2, -3)).cross(m).norm() < 16 * epsilon);   // at the foot of the perpendicular
}

TEST_CASE("Q is the sphere's centre: with the point on the surface the sphere ends half sunk") {
  const Point centre(0, 0, 1), touched(0, 0, 0), p2(3, 0, -1);
  CHECK(ground.signed_distance(slide_target(p2, centre, {0, 0, 1})) == 1);
  CHECK(ground.signed_distance(slide_target(p2, touched, {0, 0, 1})) == 0);
}

TEST_CASE("Without a wall the sphere goes where it was sent") {
  const Slide path = roll({0, 0, 3}, {1, 2, -1}, {{ground}});
  CHECK(path.positions == std::vector<Point>{{0, 0, 3}, {1, 2, 2}});
  CHECK(path.contacts.empty());
  CHECK(path.ending == Ending::arrived);
}

TEST_CASE("A sphere at rest stays, overlapping or not") {
  const double height = GENERATE(3.0, 1.0, 0.5, 0.0);
  const Slide path = roll({0, 0, height}, {0, 0, 0}, {{ground}});
  CHECK(path.positions == std::vector<Point>{{0, 0, height}});
  CHECK(path.contacts.empty());
}

TEST_CASE("One wall: the end is the paper's P3") {
  const Slide path = roll({0, 0, 3}, {4, 2, -4}, {{ground}});
  REQUIRE(path.contacts.size() == 1);
  CHECK(path.contacts[0].time == 0.5);
  CHECK(path.contacts[0].point() == Point(2, 1, 0));
  REQUIRE(path.positions.size() == 3);
  CHECK(near(path.positions[1], {2, 1, 1}));
  CHECK(near(path.end(), slide_target({4, 2, -1}, {2, 1, 1}, {0, 0, 1})));
}

TEST_CASE("The gap is kept along the normal: as wide at one degree as head on") {
  const double degrees = GENERATE(90.0, 30.0, 1.0, 0.01);
  const double angle = degrees * std::numbers::pi / 180;
  const Slide path =
      roll({0, 0, 2}, Vector(2 * std::cos(angle), 0, -2 * std::sin(angle)) / std::sin(angle), {{ground}});
  const double gap = slide_gap * (2 + 2 / std::sin(angle));
  CHECK(path.positions[1].z() - 1 == Approx(gap).epsilon(0.1));
  CHECK(path.end().z() - 1 >= gap / 2);
}

TEST_CASE("A second wall takes its part of the motion, too") {
  const Slide path = roll({0, 0, 2}, {8, 4, -2}, {{ground, wall_x}});
  REQUIRE(path.contacts.size() == 2);
  CHECK(path.contacts[0].normal == Vector(0, 0, 1));
  CHECK(path.contacts[1].normal == Vector(-1, 0, 0));
  CHECK(path.contacts[0].time == 0.5);
  CHECK(path.contacts[1].time == 0.5);  // both at (4, 2, 1)
  CHECK(near(path.end(), {4, 4, 1}));
}

TEST_CASE("The times of the contacts are those of the whole motion") {
  const Slide path = roll({0, 0, 2}, {8, 4, -4}, {{ground, wall_x}});
  CHECK(path.contacts[0].time == Approx(0.25));
  CHECK(path.contacts[1].time == Approx(0.5));
  CHECK(near(path.end(), {4, 4, 1}));
}

TEST_CASE("In a corner of three walls the sphere stops") {
  const Slide path = roll({0, 0, 2}, {8, 8, -2}, {{ground, wall_x, wall_y}});
  CHECK(near(path.end(), {4, 4, 1}));
  CHECK(path.contacts.size() == 3);
  CHECK(path.ending == Ending::cornered);
}

TEST_CASE("Head on, the sphere stops at the wall") {
  const Slide path = roll({0, 0, 2}, {0, 0, -9}, {{ground}});
  CHECK(near(path.end(), {0, 0, 1}));
  CHECK(path.ending == Ending::cornered);
}

TEST_CASE("Along a crease of two walls the sphere slides on, whatever the angle between them") {
  const double degrees = GENERATE(10.0, 30.0, 60.0, 90.0, 120.0, 150.0, 175.0);
  const Slide path = roll({20, 0, 0}, {-40, 0, 3}, wedge(degrees), 0.5);
  const double distance = 0.5 / std::sin(degrees / 2 * std::numbers::pi / 180);
  CHECK(near(path.end(), {distance, 0, 3}, 1e-11));
}

TEST_CASE("A wedge of 30 degrees: pressed into it for a thousand frames the sphere does not move at all") {
  const Room room = wedge(30);
  const Vector wish(-0.1, GENERATE(0.0, 0.01, -0.02), 0);
  Point at = roll({3, 0.1, 0}, {-5, 0, 0}, room, 0.5).end();
  for (int frame = 0; frame < 10; ++frame) at = roll(at, wish, room, 0.5).end();
  for (int frame = 0; frame < 1000; ++frame) {
    const Slide path = roll(at, wish, room, 0.5);
    REQUIRE(path.end() == at);
    REQUIRE(path.contacts.size() <= 2);
  }
}

TEST_CASE("A way on at right angles to the wished motion is not taken") {
  // Up a ramp of 45 degrees, then an upright wall: sliding up that wall would be sideways.
  const Room room{{Plane({-1, 0, 1}, 0), Plane({-1, 0, 0}, 5)}};
  const Slide path = roll({0, 0, 2}, {9, 0, 0}, room);
  CHECK(path.ending == Ending::cornered);
  CHECK(path.end().x() == Approx(4));
}

TEST_CASE("A ramp lifts the sphere, and it goes down the other side only as far as the wish goes down") {
  const Room ramp{{ground, Plane({-1, 0, 2}, 4)}};  // rises from x = 4 on, one in two
  const Slide up = roll({0, 0, 1}, {8, 0, -0.5}, ramp);
  CHECK(up.end().z() > 1.5);
  CHECK(ramp.walls[1].signed_distance(up.end()) == Approx(1));
  const Slide down = roll(up.end(), {-8, 0, -4}, ramp);
  CHECK(down.end().z() == Approx(1));
}

TEST_CASE("A sphere that touches slides along as if it had come") {
  for (int degrees = 1; degrees < 180; degrees += 7) {
    const double angle = degrees * std::numbers::pi / 180;
    const Vector n(std::cos(angle), 0.3, std::sin(angle));
    const Plane tilted(n, 0.7);
    const Point centre = (1.5 - 0.7 / n.norm()) * tilted.normal();  // 1.5 from the plane, but for rounding
    const Vector wish(0.2, 0.9, -0.4);
    const Slide path = roll(centre, wish, {{tilted}}, 1.5);
    CAPTURE(degrees);
    const Vector expected =
        wish.dot(tilted.normal()) < 0 ? Vector(slide_target(wish, {0, 0, 0}, tilted.normal())) : wish;
    CHECK(near(path.end(), centre + expected));
    CHECK(path.contacts.size() <= 1);
  }
}

TEST_CASE("A sphere that overlaps gets no deeper, slides, and gets out") {
  CHECK(near(roll({0, 0, 0.25}, {3, 0, -1}, {{ground}}).end(), {3, 0, 0.25}));
  CHECK(roll({0, 0, 0.25}, {3, 0, 1}, {{ground}}).end() == Point(3, 0, 1.25));
}

TEST_CASE("However fast, the sphere goes through no wall") {
  const Slide path = roll({0, 0, 2}, {1e9, 3e8, -1e9}, {{ground, wall_x}}, 0.25);
  CHECK(path.end().x() <= 4.75);
  CHECK(path.end().z() >= 0.25);
  CHECK(path.end().y() == Approx(3e8));
}

TEST_CASE("A scene scaled by a power of two has the path scaled by it, bit for bit") {
  const double scale = GENERATE(0x1p-60, 0x1p-3, 2.0, 0x1p40);
  const auto path_at = [](double s) {
    const Room room{{Plane({0, 0.1, 1}, 0), Plane({-1, 0.2, 0.1}, 5 * s), Plane({0.1, -1, 0.3}, 5 * s)}};
    return slide(Moving<Sphere>{{s * Point(0, 0, 3), s * 0.7}, s * Vector(8.1, 5.3, -4.7)}, room);
  };
  const Slide path = path_at(1), scaled = path_at(scale);
  REQUIRE(path.contacts.size() >= 2);
  REQUIRE(scaled.positions.size() == path.positions.size());
  for (std::size_t i = 0; i < path.positions.size(); ++i)
    CHECK(scaled.positions[i] == scale * path.positions[i]);
  for (std::size_t i = 0; i < path.contacts.size(); ++i)
    CHECK(scaled.contacts[i].time == path.contacts[i].time);
}

TEST_CASE("After the last contact that is allowed the sphere stands") {
  const SphereSweep sweep_ground = [](const Moving<Sphere>& moving) { return sweep(moving, ground); };
  const Slide path = slide(Moving<Sphere>{{{0, 0, 3}, 1}, {4, 2, -4}}, sweep_ground, 0, 1);
  CHECK(path.ending == Ending::exhausted);
  CHECK(near(path.end(), {2, 1, 1}));
}

TEST_CASE("Walls that differ by less than the crease of them can be known act as one, others have a crease") {
  // Both rise in front of the sphere, turned about the line of sight by a hair or by a degree.
  const double angle = GENERATE(1e-15, 1e-12, 1e-9, 1e-7, 1e-3);
  const Room room{{Plane({-1, angle, 0}, 5), Plane({-1, -angle, 0}, 5)}};
  const Slide path = roll({0, 0, 0}, {9, 0, 2}, room);
  CHECK(near(path.end(), {4, 0, 2}, 1e-7 * 5));
  CHECK(path.ending == Ending::arrived);
}

TEST_CASE("Published: in a corner of 120 degrees one wall after the other makes the sphere jitter") {
  // nicholas-maltbie/OpenKCC#42, rebuilt: straight into the corner, and up; only the way up is left.
  const double x = 17.32050807568877;
  const Environment corner(Mesh({{0, -5, 0}, {0, 5, 0}, {0, 5, 20}, {0, -5, 20}, {x, -5, -10}, {x, 5, -10}},
                                {{0, 1, 2}, {0, 2, 3}, {0, 4, 5}, {0, 5, 1}}));
  const Slide path =
      slide(Moving<Sphere>{{{5.196152422706632, 0, 3}, 0.5}, {-6.928203230275509, 0.5, -4}}, corner);
  CHECK(path.contacts.size() == 2);
  CHECK(path.contacts[0].time == Approx(0.6778312163512968));
  CHECK(near(path.end(), {0.5, 0.5, 0.28867513459481287}));
  const Slide again = slide(Moving<Sphere>{{path.end(), 0.5}, {-0.6928203230275509, 0, -0.4}}, corner);
  CHECK(again.end() == path.end());
}
