#include "first_contact/sweep/sphere_box.hpp"

#include "catch.hpp"
#include "chance.hpp"
#include "first_contact/geometry/transform.hpp"
#include "first_contact/sweep/moved_out.hpp"
#include "oracle/exact_triangle.hpp"

using namespace first_contact;

namespace {

/// The twelve triangles of a box whose centre is the origin.
std::vector<Triangle> surface(const Box& box) {
  const auto v = box.vertices();
  std::vector<Triangle> triangles;
  for (unsigned axis = 0; axis < 3; ++axis)
    for (const unsigned base : {0U, 1U << axis}) {
      const unsigned i = base + (1U << (axis + 1) % 3), j = base + (1U << (axis + 2) % 3);
      triangles.emplace_back(v[base], v[i], v[i + j - base]);
      triangles.emplace_back(v[base], v[i + j - base], v[j]);
    }
  return triangles;
}

Box random_box(Chance& random) {
  const Vector size(random.log_uniform(1e-3, 2), random.log_uniform(1e-3, 2), random.log_uniform(1e-3, 2));
  return Rigid::turned(random.direction(), random.uniform(0, 3))
      .box({{0, 0, 0}, {size.x(), 0, 0}, {0, size.y(), 0}, {0, 0, size.z()}});
}

/// Toward a vertex, an edge or a face of the box, or a little beside it.
Moving<Sphere> aimed(Chance& random, const Box& box) {
  const auto part = [&] { return random.pick(2) ? random.uniform(-0.5, 0.5) : random.pick(2) ? 0.5 : -0.5; };
  const Point target = part() * box.r + part() * box.s + part() * box.t;
  const Point from = target + random.uniform(1, 6) * random.direction();
  const double radius = random.pick(4) ? random.log_uniform(1e-3, 2) : 0;
  return {Sphere{from, radius}, random.uniform(0.5, 2) * (target + radius * random.direction() - from)};
}

}  // namespace

TEST_CASE("A sphere meets a box at the time that exact arithmetic finds, within the stated bound") {
  Chance random(31);
  int hits = 0;
  for (int i = 0; i < 300; ++i) {
    const Box box = random_box(random);
    const Moving<Sphere> moving = aimed(random, box);
    if (overlap(moving.shape, box)) continue;
    INFO("cast " << i << ", seed 31");
    const double reach = moving.shape.center.norm() + 2 * (box.r + box.s + box.t).norm() +
                         moving.displacement.norm() + moving.shape.radius;
    const double delta = rounding_of_distance * reach;
    std::optional<oracle::Real> earliest, latest;
    for (const Triangle& triangle : surface(box)) {
      const oracle::Approach approach(triangle, moving.shape.center, moving.displacement);
      const auto least = [](std::optional<oracle::Real>& best, const std::optional<oracle::Real>& other) {
        if (other && (!best || *other < *best)) best = other;
      };
      least(earliest, approach.first_time(oracle::Real(moving.shape.radius) + delta));
      if (moving.shape.radius > delta)
        least(latest, approach.first_time(oracle::Real(moving.shape.radius) - delta));
    }
    const auto contact = sweep(moving, box);
    hits += contact.has_value();
    if (latest) REQUIRE(contact);
    if (!contact) continue;
    REQUIRE(earliest);
    CHECK(contact->time >= static_cast<double>(*earliest) * (1 - 1e-15));
    if (latest) CHECK(contact->time <= static_cast<double>(*latest) * (1 + 1e-15));
    CHECK(contact->normal.dot(moving.displacement) < 0);
  }
  CHECK(hits > 100);
}
