#include "first_contact/response/slide.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

// The order matters: Catch2 before RapidCheck.
#include "catch.hpp"
#include "first_contact/sweep/sphere_plane.hpp"
#include "room.hpp"
//
#include <rapidcheck.h>
#include <rapidcheck/catch.h>

using namespace first_contact;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// A number in [-1, 1) with few digits, so that creases at right angles and ties occur, or with many.
double number() {
  const int coarse = *rc::gen::inRange(-4, 5), fine = *rc::gen::inRange(-1000000, 1000000);
  return *rc::gen::arbitrary<bool>() ? coarse / 4.0 : fine / 1000003.0;
}

Vector vector() { return {number(), number(), number()}; }

Vector direction() {
  const Vector v = vector();
  RC_PRE(v.norm() > 0.01);
  return v.normalized();
}

/// Walls at a distance of a radius or more from a place.
Room room_around(const Point& place, double radius) {
  Room room;
  const int walls = *rc::gen::inRange(1, 7);
  for (int i = 0; i < walls; ++i) {
    const Vector n = direction();
    const double distance = radius * (1 + 64 * epsilon + std::abs(number()));
    room.walls.push_back(Plane::through(place - distance * n, n));
  }
  return room;
}

double clearance(const Point& center, const Room& room) {
  double least = std::numeric_limits<double>::infinity();
  for (const Plane& wall : room.walls) least = std::min(least, std::abs(wall.signed_distance(center)));
  return least;
}

bool on_one_side(const Slide& path, const Room& room) {
  return std::all_of(room.walls.begin(), room.walls.end(), [&](const Plane& wall) {
    return std::all_of(path.positions.begin(), path.positions.end(), [&](const Point& p) {
      return (wall.signed_distance(p) > 0) == (wall.signed_distance(path.positions[0]) > 0);
    });
  });
}

struct Trip {
  Room room;
  Moving<Sphere> ball;
  double scale;  // the largest coordinate of the scene
};

Trip random_trip() {
  const Point start = 10 * vector();
  const double radius = 0.1 + std::abs(number());
  const Vector wish = *rc::gen::element(1e-9, 0.1, 1.0, 30.0) * vector();
  const Room room = room_around(start, radius);
  const double scale = std::max(
      {start.lpNorm<Eigen::Infinity>() + wish.lpNorm<Eigen::Infinity>(), largest_coordinate(room), radius});
  return {room, Moving<Sphere>{{start, radius}, wish}, scale};
}

}  // namespace

TEST_CASE("A slide in a room of any walls never penetrates, never goes through, never back, never too far") {
  rc::prop("so", [] {
    const auto [room, ball, scale] = random_trip();
    const Slide path = slide(ball, room);
    RC_LOG() << "planes:";
    for (const Plane& wall : room.walls) RC_LOG() << " [" << wall.coefficients().transpose() << "]";
    RC_LOG() << " start " << ball.shape.center.transpose() << " wish " << ball.displacement.transpose()
             << std::endl;

    RC_ASSERT(path.ending != Ending::exhausted);
    RC_ASSERT(on_one_side(path, room));
    double length = 0;
    for (std::size_t i = 1; i < path.positions.size(); ++i) {
      const Vector leg = path.positions[i] - path.positions[i - 1];
      length += leg.norm();
      RC_ASSERT(leg.dot(ball.displacement.normalized()) >= -4 * epsilon * scale);
    }
    RC_ASSERT(length <= ball.displacement.norm() + 16 * epsilon * scale);
    // The distance is computed with an error of up to 2 eps, too.
    for (const Point& p : path.positions)
      RC_ASSERT(clearance(p, room) >= ball.shape.radius - 4 * epsilon * scale);
  });
}

TEST_CASE(
    "Frame after frame with the same wish a slide comes to rest or goes on, and never comes nearer than its "
    "radius") {
  rc::prop("so", [] {
    const auto [room, ball, scale] = random_trip();
    Sphere sphere = ball.shape;
    const double far = 1e3 * scale;
    for (int frame = 0; frame < 200 && sphere.center.norm() < far; ++frame) {
      const Slide path = slide(Moving<Sphere>{sphere, ball.displacement}, room);
      RC_ASSERT(path.ending != Ending::exhausted);
      RC_ASSERT((path.end() - sphere.center).dot(ball.displacement.normalized()) >= -4 * epsilon * far);
      sphere.center = path.end();
      RC_ASSERT(clearance(sphere.center, room) >= sphere.radius - 4 * epsilon * far);
    }
  });
}

TEST_CASE(
    "Where walls are touched at once, the slide is the motion nearest to the wish that leads into none of "
    "them") {
  // v is that motion if it leads into no wall, and (wish - v).u <= 0 for every u that leads into none.
  rc::prop("so", [] {
    const double radius = 0.1 + std::abs(number());
    const Vector wish = vector();
    Room room;
    const int walls = *rc::gen::inRange(1, 5);
    for (int i = 0; i < walls; ++i)
      room.walls.emplace_back(direction(), radius);  // all touch the sphere about 0
    const Slide path = slide(Moving<Sphere>{{{0, 0, 0}, radius}, wish}, room);
    const Vector v = path.end();
    const auto leads_into_none = [&room = room](const Vector& u, double tolerance) {
      return std::all_of(room.walls.begin(), room.walls.end(),
                         [&](const Plane& wall) { return wall.normal().dot(u) >= -tolerance; });
    };
    RC_CLASSIFY(path.ending == Ending::cornered, "cornered");
    RC_CLASSIFY(path.ending == Ending::arrived && path.contacts.size() >= 2, "slid along a crease");
    RC_ASSERT(leads_into_none(v, 1e-12));
    for (int i = 0; i < 200; ++i) {
      const Vector u = Vector(std::sin(i * 12.9898), std::sin(i * 78.233), std::sin(i * 37.719)).normalized();
      if (leads_into_none(u, 0)) RC_ASSERT((wish - v).dot(u) <= 1e-12);
    }
  });
}
