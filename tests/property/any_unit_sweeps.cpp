// The range of numbers that contact.hpp promises, at its ends: single shapes.
#include "first_contact/batch/batch.hpp"
#include "first_contact/bvh/bvh.hpp"
#include "first_contact/geometry/box.hpp"
#include "first_contact/pairs/first_contacts.hpp"
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
#include "moving_columns.hpp"
#include "property/in_units.hpp"

using namespace first_contact;
using namespace in_units;

namespace {

int hits = 0;

// The first contact; counted, so that a test can tell that there are some.
const auto first_contact_of = [](const auto& mover, const auto& obstacle) {
  const auto contact = sweep(mover, obstacle);
  hits += contact.has_value();
  return contact;
};

Plane plane(Scene& scene) {
  const Vector normal = scene.vector(1) + Vector(0, 0, 2);
  return {normal, scene.number(-1, 1)};
}

Moving<Point> center_of(const Moving<Sphere>& ball) { return {ball.shape.center, ball.displacement}; }

}  // namespace

TEST_CASE("A sphere meets a plane, a sphere, a triangle and a box at the same time in every unit") {
  hits = 0;
  in_every_unit(1301, 400, [](Scene& scene) {
    const Moving<Sphere> ball = scene.ball(), other = scene.ball();
    check_in_every_unit(first_contact_of, ball, plane(scene));
    check_in_every_unit(first_contact_of, ball, other);
    check_in_every_unit(first_contact_of, ball, other.shape);
    check_in_every_unit(first_contact_of, ball, scene.triangle());
    check_in_every_unit(first_contact_of, ball, scene.box());
  });
  CHECK(hits > 8000);
}

TEST_CASE("A point meets a plane, a sphere, a triangle, a box and a mesh at the same time in every unit") {
  hits = 0;
  in_every_unit(1309, 200, [](Scene& scene) {
    const Moving<Point> point = center_of(scene.ball());
    check_in_every_unit(first_contact_of, point, plane(scene));
    check_in_every_unit(first_contact_of, point, scene.ball().shape);
    check_in_every_unit(first_contact_of, point, scene.triangle());
    check_in_every_unit(first_contact_of, point, scene.box());
    check_in_every_unit(
        [](const auto& p, const Mesh& mesh) { return first_contact_of(p, Environment(mesh)); }, point,
        scene.mesh());
  });
  CHECK(hits > 4000);
}

TEST_CASE("A box meets a plane, a sphere, a box, a triangle and a mesh at the same time in every unit") {
  hits = 0;
  in_every_unit(1302, 200, [](Scene& scene) {
    const Box box = scene.box();
    const Moving<Box> moving{box, scene.vector(4)};
    check_in_every_unit(first_contact_of, moving, plane(scene));
    check_in_every_unit(first_contact_of, moving, scene.ball().shape);
    check_in_every_unit(first_contact_of, moving, scene.box());
    check_in_every_unit(first_contact_of, moving, scene.triangle());
    check_in_every_unit(
        [](const auto& b, const Mesh& mesh) { return first_contact_of(b, Environment(mesh)); }, moving,
        scene.mesh());
  });
  CHECK(hits > 2000);
}

TEST_CASE("A sphere meets an environment, the plain tree and the fast one at the same time in every unit") {
  hits = 0;
  in_every_unit(1303, 100, [](Scene& scene) {
    const Mesh mesh = scene.mesh();
    std::vector<Moving<Sphere>> balls;
    for (int k = 0; k < 10; ++k) balls.push_back(scene.ball());
    const Environment environment(mesh);
    for (const int power : powers) {
      CAPTURE(power);
      const Environment large(times(mesh, power));
      const Bvh tree(times(mesh, power));
      const PlainBvh plain(times(mesh, power));
      for (const auto& ball : balls) {
        const auto contact = first_contact_of(ball, environment);
        check_scaled(sweep(times(ball, power), large), contact, power);
        check_scaled(sweep(times(ball, power), tree), contact, power);
        check_scaled(sweep(times(ball, power), plain), contact, power);
      }
    }
  });
  CHECK(hits > 3000);
}

TEST_CASE("Spheres begin to touch and part at the same times in every unit of length, and of time") {
  int touching = 0;
  in_every_unit(1310, 400, [&](Scene& scene) {
    const Moving<Sphere> p = scene.ball(), q = scene.ball();
    const auto at_size_1 = contact_interval(p, q);
    const Interval when{-0.5, 1.5};
    const auto first = sweep(p, q, when);
    touching += at_size_1.has_value();
    for (const int power : powers)
      for (const int pace : {-50, -5, 0}) {
        CAPTURE(power, pace);
        const auto in_units = [&](const Moving<Sphere>& ball) {
          return Moving<Sphere>{times(ball.shape, power), times(ball.displacement, power + pace)};
        };
        const auto times_now = contact_interval(in_units(p), in_units(q));
        REQUIRE(times_now.has_value() == at_size_1.has_value());
        if (!times_now) continue;
        REQUIRE(times(times_now->begin, pace) == at_size_1->begin);
        REQUIRE(times(times_now->end, pace) == at_size_1->end);
        const auto now = sweep(in_units(p), in_units(q), {times(when.first, -pace), times(when.last, -pace)});
        REQUIRE(now.has_value() == first.has_value());
        if (now) REQUIRE(times(now->time, pace) == first->time);
      }
  });
  CHECK(touching > 200);
}

TEST_CASE("A mesh that turns meets another at the same time in every unit") {
  in_every_unit(1305, 10, [](Scene& scene) {
    const Mesh mover = scene.mesh(), obstacle = scene.mesh();
    const Point hinge(0, 0, 8);
    const auto contact = sweep(Turning<Mesh>{mover, hinge, {1, 2, 3}, 2}, obstacle);
    for (const int power : {-895, -300, 300, 990}) {
      CAPTURE(power);
      check_scaled(sweep(Turning<Mesh>{times(mover, power), times(hinge, power), {1, 2, 3}, 2},
                         times(obstacle, power)),
                   contact, power);
    }
  });
}

TEST_CASE("All pairs meet at the same times in every unit") {
  in_every_unit(1306, 20, [](Scene& scene) {
    std::vector<Moving<Sphere>> balls;
    for (int k = 0; k < 40; ++k) balls.push_back(scene.ball());
    const auto found = first_contacts(balls);
    for (const int power : powers) {
      CAPTURE(power);
      std::vector<Moving<Sphere>> large;
      for (const auto& ball : balls) large.push_back(times(ball, power));
      const auto same = first_contacts(large);
      REQUIRE(same.size() == found.size());
      for (std::size_t k = 0; k < found.size(); ++k) {
        REQUIRE((same[k].first == found[k].first && same[k].second == found[k].second));
        check_scaled(same[k].contact, found[k].contact, power);
      }
    }
  });
}

TEST_CASE("A batch of spheres, or of boxes, takes the plain sweep's times in every unit") {
  in_every_unit(1308, 10, [](Scene& scene) {
    std::vector<Moving<Sphere>> p, q;
    std::vector<Moving<Box>> boxes;
    for (int k = 0; k < 37; ++k) {
      p.push_back(scene.ball()), q.push_back(scene.ball());
      boxes.push_back({scene.box(), scene.vector(4)});
    }
    const Plane wall({0.5, -0.25, 1}, 0.125);
    for (const int power : powers) {
      CAPTURE(power);
      const MovingColumns all_p(times(p, power)), all_q(times(q, power)), all_boxes(times(boxes, power));
      std::vector<double> found(p.size()), on_wall(p.size()), boxes_on_wall(p.size());
      sweep(all_p.spheres(), all_q.spheres(), found);
      sweep(all_p.spheres(), times(wall, power), on_wall);
      sweep(all_boxes.boxes(), times(wall, power), boxes_on_wall);
      for (std::size_t k = 0; k < p.size(); ++k) {
        const auto time = [](const auto& contact) { return contact ? contact->time : no_contact; };
        REQUIRE(found[k] == time(sweep(p[k], q[k])));
        REQUIRE(on_wall[k] == time(sweep(p[k], wall)));
        REQUIRE(boxes_on_wall[k] == time(sweep(boxes[k], wall)));
      }
    }
  });
}
