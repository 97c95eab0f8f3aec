#include "first_contact/batch/batch.hpp"
#include "first_contact/pairs/first_contacts.hpp"
#include "first_contact/response/impact.hpp"
#include "first_contact/sweep/box_plane.hpp"
#include "first_contact/sweep/ray_triangle.hpp"
#include "first_contact/sweep/sphere_plane.hpp"
#include "first_contact/sweep/sphere_sphere.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"
#include "record.hpp"
#include "shapes.hpp"

/// The sweeps of single shapes, alone and many at once, and the impact.
namespace digest {

namespace {

void sphere_plane(Record& record) {
  Dice dice(1);
  for (int i = 0; i < cases; ++i, record.next()) {
    const double unit = dice.scale();
    const Plane wall = plane(dice, unit);
    const Point foot = -wall.offset() * wall.normal();
    const Moving<Sphere> mover = dice.one_in(2) ? ball(dice, unit) : grazing_ball(dice, foot, unit);
    record.add(overlap(mover.shape, wall));
    record.add(sweep(mover, wall));
  }
}

void box_plane(Record& record) {
  Dice dice(2);
  for (int i = 0; i < cases; ++i, record.next()) {
    const double unit = dice.scale();
    const Plane wall = dice.one_in(3) ? Plane({0, 0, 1}, unit * dice.coordinate()) : plane(dice, unit);
    const Moving<Box> mover{box(dice, unit), unit * 2 * dice.vector()};
    record.add(overlap(mover.shape, wall));
    record.add(lowest_vertices(mover.shape, wall.normal()));
    record.add(sweep(mover, wall));
  }
}

void sphere_sphere(Record& record) {
  Dice dice(3);
  for (int i = 0; i < cases; ++i, record.next()) {
    const double unit = dice.scale();
    const Moving<Sphere> p = ball(dice, unit);
    const Moving<Sphere> q = dice.one_in(2) ? ball(dice, unit) : grazing_ball(dice, p.shape.center, unit);
    record.add(overlap(p.shape, q.shape));
    record.add(sweep(p, q));
    record.add(sweep(p, q.shape));
    record.add(sweep(p, q, Interval{-dice.part(), 1 + dice.part()}));
    const auto times = contact_interval(p, q);
    record.add(times.has_value());
    if (times) record.add(Vector2(times->begin, times->end));
  }
}

void sphere_triangle(Record& record) {
  Dice dice(4);
  for (int i = 0; i < cases; ++i, record.next()) {
    const double unit = dice.scale();
    const Triangle face = triangle(dice, unit);
    const Point place = dice.one_in(2) ? face.a : Point(face.a + dice.part() * (face.b - face.a));
    const Moving<Sphere> mover = dice.one_in(2) ? ball(dice, unit) : grazing_ball(dice, place, unit);
    record.add(overlap(mover.shape, face));
    record.add(sweep(mover, face));
  }
}

void point_triangle(Record& record) {
  Dice dice(5);
  for (int i = 0; i < cases; ++i, record.next()) {
    const double unit = dice.scale();
    const Triangle face = triangle(dice, unit);
    const Point start = unit * 2 * dice.point();
    const Point goal = dice.one_in(3) ? face.b : Point(face.a + dice.part() * (face.c - face.a));
    record.add(sweep(Moving<Point>{start, 2 * (goal - start)}, face));
  }
}

/// Shapes in columns, as a batch takes them.
struct Balls {
  std::array<std::vector<double>, 7> column;

  void add(const Moving<Sphere>& mover) {
    const auto& [c, r] = mover.shape;
    const Vector& v = mover.displacement;
    const std::array<double, 7> numbers{c.x(), c.y(), c.z(), r, v.x(), v.y(), v.z()};
    for (std::size_t i = 0; i < 7; ++i) column[i].push_back(numbers[i]);
  }
  MovingSpheres view() const {
    return {{column[0], column[1], column[2]}, column[3], {column[4], column[5], column[6]}};
  }
};

void add_all(Record& record, const std::vector<double>& times) {
  for (const double time : times) {
    record.add(time);
    record.next();
  }
}

void batch_of_spheres(Record& record) {
  Dice dice(6);
  Balls p, q;
  for (int i = 0; i < cases; ++i) {
    const double unit = dice.scale();
    p.add(ball(dice, unit));
    const Point near(p.column[0].back(), p.column[1].back(), p.column[2].back());
    q.add(dice.one_in(2) ? ball(dice, unit) : grazing_ball(dice, near, unit));
  }
  std::vector<double> times(cases);
  sweep(p.view(), q.view(), times);
  add_all(record, times);
  sweep(p.view(), Plane({1, 2, 3}, 0.125), times);
  add_all(record, times);
}

void batch_of_boxes(Record& record) {
  Dice dice(7);
  std::array<std::vector<double>, 15> column;
  for (int i = 0; i < cases; ++i) {
    const double unit = dice.scale();
    const Box b = box(dice, unit);
    const Vector way = unit * 2 * dice.vector();
    const std::array<Vector, 5> vectors{b.center, b.r, b.s, b.t, way};
    for (std::size_t k = 0; k < 15; ++k)
      column[k].push_back(vectors[k / 3][static_cast<Eigen::Index>(k % 3)]);
  }
  const auto columns = [&](std::size_t k) { return Columns{column[k], column[k + 1], column[k + 2]}; };
  std::vector<double> times(cases);
  sweep(MovingBoxes(columns(0), {columns(3), columns(6), columns(9)}, columns(12)), Plane({1, -2, 2}, 0.5),
        times);
  add_all(record, times);
}

void all_pairs(Record& record) {
  Dice dice(8);
  for (int scene = 0; scene < 100; ++scene, record.next()) {
    const double unit = dice.scale();
    std::vector<Moving<Sphere>> balls;
    for (int i = 0; i < 100; ++i) {
      const Vector far = 4 * unit * dice.point();
      const Moving<Sphere> one = ball(dice, unit / 4);
      balls.push_back({{one.shape.center + far, one.shape.radius}, one.displacement});
    }
    const auto add = [&](const PairContact& pair) {
      record.count(pair.first);
      record.count(pair.second);
      record.add(pair.contact);
    };
    for (const PairContact& pair : first_contacts(balls)) add(pair);
    if (const auto first = earliest_contact(balls)) add(*first);
  }
}

template <int Dimension>
void one_impact(Dice& dice, Record& record) {
  using V = typename Body<Dimension>::Velocity;
  const double unit = dice.scale();
  const auto vector = [&] { return V(unit * dice.vector().template head<Dimension>()); };
  const Body<Dimension> p{0.25 + dice.part(), vector()};
  const Body<Dimension> q{dice.one_in(8) ? HUGE_VAL : 3 * dice.part() + 0.125, vector()};
  V normal = vector();
  if (normal.isZero(0)) normal = V::Ones();
  const auto after = impact(p, q, normal, dice.one_in(3) ? 1 : dice.part());
  record.add(after.velocity_p);
  record.add(after.velocity_q);
  record.add(after.impulse);
}

void impacts(Record& record) {
  Dice dice(9);
  for (int i = 0; i < cases; ++i, record.next()) {
    one_impact<2>(dice, record);
    one_impact<3>(dice, record);
  }
}

}  // namespace

std::vector<Verb> sweep_verbs() {
  return {{"sweep sphere plane", sphere_plane},
          {"sweep box plane", box_plane},
          {"sweep sphere sphere", sphere_sphere},
          {"sweep sphere triangle", sphere_triangle},
          {"sweep point triangle", point_triangle},
          {"sweep batch of spheres", batch_of_spheres},
          {"sweep batch of boxes", batch_of_boxes},
          {"first contacts of all pairs", all_pairs},
          {"impact", impacts}};
}

}  // namespace digest
