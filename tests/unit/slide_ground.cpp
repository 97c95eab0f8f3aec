// Slides over grounds of many triangles: floors, ramps, steps.
#include <cmath>
#include <limits>
#include <vector>

#include "catch.hpp"
#include "first_contact/response/slide.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"

using namespace first_contact;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

bool near(const Point& a, const Point& b, double tolerance = 1e-12) { return (a - b).norm() <= tolerance; }

/// A level floor of n x n squares, two triangles each, cut along alternating diagonals.
Mesh tessellated_floor(unsigned n, double side) {
  std::vector<Point> vertices;
  std::vector<Mesh::Face> faces;
  for (unsigned j = 0; j <= n; ++j)
    for (unsigned i = 0; i <= n; ++i) vertices.emplace_back((i - n / 2.0) * side, (j - n / 2.0) * side, 0);
  for (unsigned j = 0; j < n; ++j)
    for (unsigned i = 0; i < n; ++i) {
      const unsigned a = j * (n + 1) + i, b = a + 1, c = a + n + 2, d = a + n + 1;
      if ((i + j) % 2) {
        faces.push_back({a, b, c});
        faces.push_back({a, c, d});
      } else {
        faces.push_back({a, b, d});
        faces.push_back({b, c, d});
      }
    }
  return {std::move(vertices), std::move(faces)};
}

/// A strip of quads along y, its cross-section in x and z given: stairs, ramps, gutters.
Mesh profile(const std::vector<Eigen::Vector2d>& corners) {
  std::vector<Point> vertices;
  std::vector<Mesh::Face> faces;
  for (const auto& corner : corners)
    for (const double y : {-5.0, 5.0}) vertices.emplace_back(corner.x(), y, corner.y());
  for (unsigned i = 0; i + 1 < corners.size(); ++i) {
    faces.push_back({2 * i, 2 * i + 2, 2 * i + 3});
    faces.push_back({2 * i, 2 * i + 3, 2 * i + 1});
  }
  return {std::move(vertices), std::move(faces)};
}

}  // namespace

TEST_CASE(
    "A flat floor of many triangles is flat: no edge is felt, and after a thousand frames nothing has "
    "drifted") {
  const Environment level(tessellated_floor(12, 0.7));
  Sphere ball{{0, -2, 0.4}, 0.4};
  for (int frame = 0; frame < 1000; ++frame) {
    const double angle = 0.01 * frame;
    const Slide path =
        slide(Moving<Sphere>{ball, {0.02 * std::cos(angle), 0.02 * std::sin(angle), -0.03}}, level);
    REQUIRE(path.contacts.size() == 1);
    REQUIRE(path.contacts[0].feature == Feature::face);
    ball.center = path.end();
    REQUIRE(std::abs(ball.center.z() - 0.4) < 1e-12);
  }
  CHECK(near(ball.center, {2 * std::sin(10), -2 * std::cos(10), 0.4}, 0.05));
}

TEST_CASE("Up a ramp, over its ridge and down again, a frame at a time") {
  const Environment hill(profile({{-5, 0}, {0, 0}, {2, 1}, {4, 0}, {9, 0}}));
  Sphere ball{{-3, 0, 0.5}, 0.5};
  double highest = 0;
  for (int frame = 0; frame < 200; ++frame) {
    const Slide path = slide(Moving<Sphere>{ball, {0.06, 0, -0.02}}, hill);
    REQUIRE(path.end().x() > ball.center.x());
    ball.center = path.end();
    highest = std::max(highest, ball.center.z());
    REQUIRE_FALSE(overlap(Sphere{ball.center, 0.5 * (1 - 1e-14)}, hill));
  }
  CHECK(ball.center.x() > 4.5);
  CHECK(ball.center.z() == Approx(0.5));
  CHECK(highest == Approx(1.5).epsilon(0.01));
}

TEST_CASE("Over a step lower than the radius the sphere rolls, a higher one stops it") {
  const double step = GENERATE(0.1, 0.3, 0.6);
  const Environment stairs(profile({{-5, 0}, {0, 0}, {0, step}, {5, step}}));
  Sphere ball{{-2, 0, 0.5}, 0.5};
  for (int frame = 0; frame < 300; ++frame) {
    const Slide path = slide(Moving<Sphere>{ball, {0.02, 0, -0.001}}, stairs);
    REQUIRE(path.end().x() >= ball.center.x());
    ball.center = path.end();
  }
  if (step < 0.5) {
    CHECK(ball.center.x() > 1);
    CHECK(ball.center.z() > 0.5 + step - 1e-12);
  } else {
    CHECK(ball.center.x() == Approx(-0.5));
    CHECK(ball.center.z() == Approx(0.5));
  }
}

TEST_CASE("One triangle is an obstacle, too") {
  const Triangle triangle({-5, -5, 0}, {5, -5, 0}, {0, 5, 0});
  CHECK(near(slide(Moving<Sphere>{{{0, 0, 2}, 0.5}, {1, 0, -4}}, triangle).end(), {1, 0, 0.5}));
}

TEST_CASE(
    "Published: a gap laid along the velocity is next to none at a shallow approach, and the slide hops") {
  // gamedev.net, a thread of 2016 on Fauerby's "Improved Collision detection and Response" (2003), page 46:
  // the numbers are rebuilt.
  const Environment level(
      Mesh({{-200, 0, -200}, {-200, 0, 200}, {200, 0, 200}, {200, 0, -200}}, {{0, 1, 2}, {0, 2, 3}}));
  const Slide path = slide(Moving<Sphere>{{{0, 1.01, 0}, 1}, {100, -0.1, 0}}, level);
  REQUIRE(path.contacts.size() == 1);
  CHECK(path.contacts[0].time == Approx(0.1));
  CHECK(path.contacts[0].normal == Vector(0, 1, 0));
  CHECK(path.contacts[0].feature == Feature::face);
  CHECK(near(path.end(), {100, 1, 0}));
  const double gap = path.positions[1].y() - 1;
  CHECK(gap >= 0.5 * slide_gap * 200);
  CHECK(gap <= 2 * slide_gap * 200);
}
