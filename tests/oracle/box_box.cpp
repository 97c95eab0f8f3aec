#include "first_contact/sweep/box_box.hpp"

#include <array>

#include "catch.hpp"
#include "chance.hpp"
#include "first_contact/geometry/transform.hpp"
#include "first_contact/sweep/box_mesh.hpp"

using namespace first_contact;

namespace {

/// Does a segment share a point with a box whose sides are all moved in by `less`? Cut at the three pairs of
/// planes: no separating direction is asked.
bool meets(const Box& box, const Point& from, const Point& to, double less) {
  double enter = 0, leave = 1;
  for (const Vector& axis : {box.r, box.s, box.t}) {
    const Vector unit = axis.normalized();
    const double half = 0.5 * axis.norm() - less, start = unit.dot(from - box.center),
                 way = unit.dot(to - from);
    if (way == 0 && std::abs(start) > half) return false;
    if (way == 0) continue;
    enter = std::max(enter, std::min((-half - start) / way, (half - start) / way));
    leave = std::min(leave, std::max((-half - start) / way, (half - start) / way));
  }
  return enter <= leave;
}

/// Two solids share a point if an edge of one does with the other.
bool share_a_point(const Box& a, const Box& b, double less) {
  for (const auto& [edges, solid] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    const auto vertices = edges->vertices();
    for (unsigned i = 0; i < 8; ++i)
      for (const unsigned axis : {1U, 2U, 4U})
        if (!(i & axis) && meets(*solid, vertices[i], vertices[i + axis], less)) return true;
  }
  return false;
}

Box random_box(Chance& random, const Point& center) {
  const Vector size(random.log_uniform(0.05, 3), random.log_uniform(0.05, 3), random.log_uniform(0.05, 3));
  const Rigid turn = random.pick(4) ? Rigid::turned(random.direction(), random.uniform(0, 3)) : Rigid();
  return Rigid::moved_by(center).box(
      turn.box({{0, 0, 0}, {size.x(), 0, 0}, {0, size.y(), 0}, {0, 0, size.z()}}));
}

Box moved(const Box& box, const Vector& by) { return {box.center + by, box.r, box.s, box.t}; }

constexpr double depth = 1e-9;  // what is no deeper may be rounding

}  // namespace

TEST_CASE("Dense sampling finds two boxes apart until they touch, and together just after") {
  Chance random(17);
  int hits = 0;
  for (int i = 0; i < 400; ++i) {
    const Box obstacle = random_box(random, {0, 0, 0});
    const Box start = random_box(random, 5 * random.direction());
    if (share_a_point(start, obstacle, -depth)) continue;
    const Moving moving{start, 1.5 * (random.vector(1) - start.center)};
    INFO("case " << i << ", seed 17");
    const auto contact = sweep(moving, obstacle);
    hits += contact.has_value();
    const double end = contact ? contact->time : 1;
    for (int k = 0; k < 100; ++k)
      CHECK_FALSE(share_a_point(moved(start, k / 100.0 * end * moving.displacement), obstacle, depth));
    if (!contact) continue;
    const Vector there = contact->time * moving.displacement;
    CHECK(share_a_point(moved(start, there), obstacle, -depth));
    CHECK(contact->normal.dot(moving.displacement) < 0);
    const Point p = contact->point();  // on both
    CHECK(meets(obstacle, p, p, -depth));
    CHECK(meets(moved(start, there), p, p, -depth));
  }
  CHECK(hits > 100);
}

TEST_CASE("Far away and at any scale, a box meets a box at the same time, within the stated bound") {
  Chance random(18);
  for (int i = 0; i < 200; ++i) {
    const Box obstacle = random_box(random, {0, 0, 0}), start = random_box(random, 5 * random.direction());
    const Moving moving{start, -1.5 * start.center};
    const auto contact = sweep(moving, obstacle);
    if (!contact) continue;
    INFO("case " << i << ", seed 18");
    for (const double scale : {0x1p-100, 0x1p100}) {
      const auto scaled_box = [&](const Box& box) {
        return Box{scale * box.center, scale * box.r, scale * box.s, scale * box.t};
      };
      const auto scaled =
          sweep(Moving{scaled_box(start), Vector(scale * moving.displacement)}, scaled_box(obstacle));
      REQUIRE(scaled);
      CHECK(scaled->time == contact->time);
      CHECK(scaled->normal == contact->normal);
      CHECK(scaled->point() == scale * contact->point());
    }
  }
}

TEST_CASE("A box whose faces are triangles is met when the box is") {
  Chance random(19);
  int hits = 0;
  for (int i = 0; i < 200; ++i) {
    const Box obstacle = random_box(random, {0, 0, 0}), start = random_box(random, 5 * random.direction());
    if (overlap(start, obstacle)) continue;
    const auto v = obstacle.vertices();
    std::vector<Mesh::Face> faces;
    for (unsigned axis = 0; axis < 3; ++axis)
      for (const unsigned base : {0U, 1U << axis}) {
        const unsigned a = base + (1U << (axis + 1) % 3), b = base + (1U << (axis + 2) % 3);
        faces.push_back({base, a, a + b - base});
        faces.push_back({base, a + b - base, b});
      }
    const Moving moving{start, 1.5 * (random.vector(1) - start.center)};
    INFO("case " << i << ", seed 19");
    const auto one = sweep(moving, obstacle);
    const auto other = sweep(moving, Environment(Mesh({v.begin(), v.end()}, faces)));
    REQUIRE(one.has_value() == other.has_value());
    if (!one) continue;
    ++hits;
    CHECK(std::abs(one->time - other->time) < 1e-12);
    CHECK((one->normal - other->normal).norm() < 1e-9);
  }
  CHECK(hits > 50);
}
