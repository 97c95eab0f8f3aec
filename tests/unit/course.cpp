#include "first_contact/sweep/course.hpp"

#include <limits>

#include "catch.hpp"

using namespace first_contact;

namespace {

// About the z axis by 2 in a unit of time, and along x by 3.
const Turning<Mesh> turning{
    Mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}), {0, 0, 0}, {0, 0, 1}, 2, {3, 0, 0}};

}  // namespace

TEST_CASE(
    "A point that turns is as fast as the angle times its distance from the axis, whose own way is added") {
  const Going going(turning, 0);
  CHECK(going.velocity({0, 0.25, 7}) == Vector(3 - 0.5, 0, 0));
  CHECK(going.speed_of({Point(0, 0.25, 7)}) == 3.5);
  CHECK(going.speed_of({Point(0, 0.25, 7), Point(0.5, 0, -1)}) == 4);
  CHECK(going.speed_of({Point(0, 0, 1)}) == 3);
}

TEST_CASE(
    "As seen along a normal at a right angle to the axis, a point bends by the angle squared times its "
    "distance") {
  const Course course = Going(turning, 0).of({0.25, 0, 5}, {1, 0, 0}, {-1, 0, 0});
  CHECK(course.height == 1.25);
  CHECK(course.rate == 3);
  CHECK(course.bend == 1);
}

TEST_CASE("A point that comes down by its rate, bent by half its bend a time squared, gets there by then") {
  CHECK(time_above(1, {4, -2, 0}) == 1.5);
  CHECK(time_above(0, {4, 0, 2}) == 2);
  CHECK(time_above(0, {4, 3, 2}) == 4);   // 4 + 3 t - t^2
  CHECK(time_above(0, {4, -3, 2}) == 1);  // 4 - 3 t - t^2
  CHECK(time_above(0, {4, 3, 0}) == std::numeric_limits<double>::infinity());
}
