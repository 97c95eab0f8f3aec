// What the museum shows and no exercise has: each fault gives another answer than the library.
#include "workbook/museum.hpp"

#include "catch.hpp"
#include "first_contact/motion/bounce.hpp"
#include "first_contact/motion/easing.hpp"
#include "first_contact/response/slide.hpp"
#include "first_contact/sweep/box_box.hpp"
#include "first_contact/sweep/box_plane.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "first_contact/sweep/sphere_plane.hpp"

namespace museum = workbook::museum;
using namespace first_contact;

TEST_CASE("Museum: the contact point of a sunk vertex is on the plane, not twice as deep as the vertex") {
  const workbook::Point wrong = museum::contact_point({{0, 0, 1}, 0}, {0, 0, -0.2});
  CHECK(wrong.z == Approx(-0.4));
  const Box cube({0, 0, 0.3}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  const auto contact = sweep(Moving{cube, Vector(0, 0, -1)}, Plane({0, 0, 1}, 0));
  REQUIRE(contact);
  CHECK(contact->points.row(2).cwiseAbs().maxCoeff() == Approx(0).margin(1e-15));
}

TEST_CASE("Museum: boxes a hundred apart do not overlap, whatever a box says of itself") {
  CHECK(museum::boxes_overlap({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                              {{100, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  const Vector x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  CHECK_FALSE(overlap(Box({0, 0, 0}, x, y, z), Box({100, 0, 0}, x, y, z)));
}

TEST_CASE("Museum: the seam of a flat floor does not push back a ball that rolls over it") {
  CHECK(museum::normal_at_seam({-2, 0, 0.99}, {4, 0, 0}, 1, {0, 0, 0}).x < -0.1);
  const Environment floor(Mesh({{-4, -4, 0}, {0, -4, 0}, {4, -4, 0}, {-4, 4, 0}, {0, 4, 0}, {4, 4, 0}},
                               {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}}));
  CHECK_FALSE(sweep(Moving<Sphere>{{{-2, 0, 0.99}, 1}, {4, 0, 0}}, floor));
}

TEST_CASE("Museum: a slide ends with the ball on the wall, not with its centre in it") {
  CHECK(museum::slide_end({{0, 0, 1}, 0}, {0, 0, 0}, {3, 0, -1}).z == Approx(0));
  const Plane floor({0, 0, 1}, 0);
  CHECK(slide(Moving<Sphere>{{{-1, 0, 2}, 1}, {3, 0, -2}}, floor).end().z() == Approx(1));
}

TEST_CASE("Museum: flights that shrink never reach the end of the film, but the ball rests") {
  CHECK(museum::impacts_before(10, 1, 0.5, 5000) == 5000);
  CHECK(Bounce(1, 0, 9.81, 0.5).rest_time().value() < 10);
}

TEST_CASE("Museum: a ball that is turned in each frame in which it overlaps never leaves the paddle") {
  CHECK(museum::height_after(1000, 0.1, -1.0 / 16, 1) < 1);
  CHECK_FALSE(sweep(Moving<Sphere>{{{0, 0, 0.1}, 1}, {0, 0, 0.5}}, Plane({0, 0, 1}, 0)));
}

TEST_CASE("Museum: an elastic easing passes 1 long before it ends") { CHECK(museum::time_of_end(60) < 0.2); }
