// The range of numbers that contact.hpp promises, at its ends: shapes at rest, what is seen, and what is hit.
#include "first_contact/geometry/bounding.hpp"
#include "first_contact/geometry/closest_point.hpp"
#include "first_contact/geometry/frustum.hpp"
#include "first_contact/geometry/line_triangle.hpp"
#include "first_contact/geometry/triangle_distance.hpp"
#include "first_contact/stage/hit_test.hpp"
#include "first_contact/sweep/box_box.hpp"
#include "first_contact/sweep/box_mesh.hpp"
#include "first_contact/sweep/box_plane.hpp"
#include "first_contact/sweep/sphere_box.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "first_contact/sweep/sphere_plane.hpp"
#include "first_contact/sweep/sphere_sphere.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"
#include "property/in_units.hpp"

using namespace first_contact;
using namespace in_units;

namespace {

void check_overlap(const auto& a, const auto& b) {
  const bool at_size_1 = overlap(a, b);
  for (const int power : powers) {
    CAPTURE(power);
    REQUIRE(overlap(times(a, power), times(b, power)) == at_size_1);
  }
}

std::vector<Point> points(Scene& scene, int count, double size) {
  std::vector<Point> all;
  for (int i = 0; i < count; ++i) all.push_back(scene.vector(size));
  return all;
}

// Of few digits, as the rest: so their corners are exact on any stage.
StageObject stage_object(const std::vector<Point>& corners, int power) {
  std::vector<Point2> outline;
  for (const Point& corner : corners) outline.push_back(times(corner, power).head<2>());
  return StageObject(outline);
}

}  // namespace

TEST_CASE("What overlaps does so in every unit") {
  in_every_unit(1304, 400, [](Scene& scene) {
    const Sphere ball = scene.ball().shape;
    const Box box = scene.box();
    const Vector normal = scene.vector(1) + Vector(0, 0, 2);
    const Plane plane(normal, scene.number(-1, 1));
    check_overlap(ball, plane);
    check_overlap(ball, scene.ball().shape);
    check_overlap(ball, scene.triangle());
    check_overlap(ball, box);
    check_overlap(ball, scene.mesh());
    check_overlap(box, plane);
    check_overlap(box, scene.box());
    check_overlap(box, scene.triangle());
    check_overlap(box, scene.mesh());
    check_overlap(scene.triangle(), bounds_between(Point(-1, -0.5, -0.25), Point(0.5, 1, 0.75)));
  });
}

TEST_CASE("The nearest points, and where a line meets a triangle, are the same in every unit") {
  in_every_unit(1311, 400, [](Scene& scene) {
    const Point from = scene.vector(4), to = scene.vector(4);
    const Triangle a = scene.triangle(), b = scene.triangle();
    const NearestPoints pair = nearest_points(a, b);
    const auto weights = weights_where_line_meets(from, to, a);
    for (const int power : powers) {
      CAPTURE(power);
      const Triangle large = times(a, power);
      check_scaled(closest_point(times(from, power), large), closest_point(from, a), power);
      const NearestPoints large_pair = nearest_points(large, times(b, power));
      check_scaled(large_pair.first, pair.first, power);
      check_scaled(large_pair.second, pair.second, power);
      const auto same = weights_where_line_meets(times(from, power), to, large);
      REQUIRE(same.has_value() == weights.has_value());
      if (same) REQUIRE(*same == *weights);
    }
  });
}

TEST_CASE("What bounds some points bounds them in every unit") {
  in_every_unit(1312, 100, [](Scene& scene) {
    const std::vector<Point> some = points(scene, 12, 1);
    const Sphere sphere = bounding_sphere(some);
    const Box upright = bounding_box(some), turned = principal_box(some);
    for (const int power : powers) {
      CAPTURE(power);
      const std::vector<Point> large = times(some, power);
      check_scaled(bounding_sphere(large).center, sphere.center, power);
      check_scaled(bounding_sphere(large).radius, sphere.radius, power);
      check_scaled(bounding_box(large).center, upright.center, power);
      check_scaled(bounding_box(large).r, upright.r, power);
      check_scaled(principal_box(large).center, turned.center, power);
      check_scaled(principal_box(large).t, turned.t, power);
    }
  });
}

TEST_CASE("A frustum has the same six normals in every unit, and rejects the same shapes") {
  int kept = 0, refused = 0;
  in_every_unit(1313, 300, [&](Scene& scene) {
    const double near_z = scene.number(0.01, 1), far_z = near_z + scene.number(0.01, 8);
    const Vector axis = scene.vector(1) + Vector(0, 0, 2);
    const double angle = scene.number(-3, 3);
    const Point eye = scene.vector(2);
    const Sphere ball = scene.ball().shape;
    const Box box = scene.box();
    const auto sight = [&](int power) {
      const Rigid camera = Rigid::moved_by(times(eye, power)).after(Rigid::turned(axis, angle));
      return Frustum(Transform::perspective(1.2, 1.5, times(near_z, power), times(far_z, power))
                         .after(camera.inverse().transform()));
    };
    const Frustum at_size_1 = sight(0);
    (rejected(at_size_1, ball) ? refused : kept) += 1;
    for (const int power : powers) {
      CAPTURE(power);
      const Frustum large = sight(power);
      for (std::size_t i = 0; i < 6; ++i) {
        REQUIRE(large.planes[i].normal() == at_size_1.planes[i].normal());
        check_scaled(large.planes[i].offset(), at_size_1.planes[i].offset(), power);
      }
      REQUIRE(rejected(large, times(ball, power)) == rejected(at_size_1, ball));
      REQUIRE(rejected(large, times(box, power)) == rejected(at_size_1, box));
    }
  });
  CHECK(kept > 30);
  CHECK(refused > 30);
}

TEST_CASE("A frustum from as near as 2^-900 to as far as 2^1000 rejects nothing that is seen") {
  const Frustum sight(Transform::perspective(1, 1, 0x1p-900, 0x1p1000));
  for (int power = -899; power < 1000; power += 60) {
    CAPTURE(power);
    CHECK_FALSE(rejected(sight, Sphere{{0, 0, -std::ldexp(1, power)}, 0}));
    CHECK(rejected(sight, Sphere{{0, 0, std::ldexp(1, power)}, 0}));
    CHECK(rejected(sight, Sphere{{std::ldexp(1, power), 0, -std::ldexp(1, power)}, 0}));
  }
}

TEST_CASE("The pointer hits, and objects meet, on a stage of any size") {
  int inside = 0;
  in_every_unit(1314, 400, [&](Scene& scene) {
    const std::vector<Point> first = points(scene, 5, 4), second = points(scene, 4, 4);
    const Point pointer = scene.chance().pick(4) ? scene.vector(4) : first[0];
    const StageObject a = stage_object(first, 0), b = stage_object(second, 0);
    const bool hit = hit_test_point(a, pointer.head<2>(), true), meet = overlap(a, b);
    inside += hit;
    for (const int power : {-1055, -1000, -895, -300, 300, 990, 1020}) {
      CAPTURE(power);
      const StageObject large_a = stage_object(first, power), large_b = stage_object(second, power);
      const Point2 there = times(pointer, power).head<2>();
      REQUIRE(hit_test_point(large_a, there, true) == hit);
      REQUIRE(hit_test_point(large_a, there) == hit_test_point(a, pointer.head<2>()));
      REQUIRE(hit_test_object(large_a, large_b) == hit_test_object(a, b));
      REQUIRE(overlap(large_a, large_b) == meet);
      REQUIRE(pick(std::vector{large_a, large_b}, there) == pick(std::vector{a, b}, pointer.head<2>()));
    }
  });
  CHECK(inside > 50);
}
