#include "first_contact/geometry/frustum.hpp"
#include "first_contact/sweep/box_box.hpp"
#include "first_contact/sweep/box_mesh.hpp"
#include "first_contact/sweep/box_plane.hpp"
#include "first_contact/sweep/sphere_box.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "first_contact/sweep/sphere_plane.hpp"
#include "first_contact/sweep/sphere_sphere.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"
#include "record.hpp"
#include "shapes.hpp"

/// Boxes, as movers and as obstacles; points; and what a camera sees of boxes and spheres.
namespace digest {

namespace {

/// Toward a place near the origin, as a ball goes.
Moving<Box> moving_box(Dice& dice, double unit) {
  const Box shape = box(dice, unit);
  const Point start = unit * 2 * dice.point(), goal = unit * 0.5 * dice.point();
  return {{start, shape.r, shape.s, shape.t}, dice.whole(1, 2) * (goal - start)};
}

/// Of a box: a vertex, or where it is halfway to the next one.
Point place_on(Dice& dice, const Box& solid) {
  const auto vertices = solid.vertices();
  const unsigned number = static_cast<unsigned>(dice.pick(8)), next = number ^ 1U << dice.pick(3);
  return dice.one_in(2) ? vertices[number] : Point(0.5 * vertices[number] + 0.5 * vertices[next]);
}

void sphere_box(Record& record) {
  Dice dice(40);
  for (int i = 0; i < cases; ++i, record.next()) {
    const double unit = dice.scale();
    const Box solid = box(dice, unit);
    const Moving<Sphere> mover =
        dice.one_in(2) ? ball(dice, unit) : grazing_ball(dice, place_on(dice, solid), unit);
    record.add(overlap(mover.shape, solid));
    record.add(sweep(mover, solid));
    record.add(sweep(Moving<Box>{solid, -mover.displacement}, mover.shape));
  }
}

void box_box(Record& record) {
  Dice dice(41);
  for (int i = 0; i < cases; ++i, record.next()) {
    const double unit = dice.scale();
    const Moving<Box> mover = moving_box(dice, unit);
    const Box solid = box(dice, unit);
    record.add(overlap(mover.shape, solid));
    record.add(sweep(mover, solid));
  }
}

void box_triangle(Record& record) {
  Dice dice(42);
  for (int i = 0; i < cases; ++i, record.next()) {
    const double unit = dice.scale();
    const Moving<Box> mover = moving_box(dice, unit);
    const Triangle face = triangle(dice, unit);
    record.add(overlap(mover.shape, face));
    record.add(sweep(mover, face));
  }
}

void box_environment(Record& record) {
  Dice dice(43);
  for (int scene = 0; scene < cases / 100; ++scene) {
    const double unit = dice.scale();
    const Environment hills(ground(dice, dice.whole(1, 3), unit));
    for (int i = 0; i < 20; ++i, record.next()) {
      const Moving<Box> mover = moving_box(dice, unit);
      record.add(overlap(mover.shape, hills));
      record.add(sweep(mover, hills));
    }
  }
}

void points(Record& record) {
  Dice dice(44);
  for (int i = 0; i < cases; ++i, record.next()) {
    const double unit = dice.scale();
    const Moving<Sphere> way = ball(dice, unit);
    const Moving<Point> point{way.shape.center, way.displacement};
    const Plane wall = plane(dice, unit);
    const Box solid = box(dice, unit);
    const Sphere other = ball(dice, unit).shape;
    record.add(sweep(point, wall));
    record.add(sweep(point, solid));
    record.add(sweep(point, other));
    record.add(overlap(point.shape, solid));
    record.add(overlap(point.shape, other));
  }
}

/// As a perspective has it, of small whole numbers: no tangent.
Transform projection(Dice& dice, double unit) {
  const double near_z = dice.whole(1, 4), far_z = near_z + dice.whole(1, 64);
  Matrix m = Matrix::Zero();
  m(0, 0) = dice.whole(1, 8) / 4.0;
  m(1, 1) = dice.whole(1, 8) / 4.0;
  m(2, 2) = -(far_z + near_z) / (far_z - near_z);
  m(2, 3) = -2 * unit * far_z * near_z / (far_z - near_z);
  m(3, 2) = -1;
  return Transform(m);
}

void frustums(Record& record) {
  Dice dice(45);
  for (int i = 0; i < cases; ++i, record.next()) {
    const double unit = dice.scale();
    const Rigid camera = turn(dice);
    const Rigid placed(Quaternion(camera.rotation()), unit * camera.translation());
    const Frustum sight(projection(dice, unit).after(placed.inverse().transform()));
    for (const Plane& side : sight.planes) record.add(side.coefficients());
    record.add(rejected(sight, box(dice, unit)));
    record.add(rejected(sight, ball(dice, 4 * unit).shape));
  }
}

}  // namespace

std::vector<Verb> box_verbs() {
  return {{"sweep sphere box", sphere_box},
          {"sweep box box", box_box},
          {"sweep box triangle", box_triangle},
          {"sweep box environment", box_environment},
          {"sweep point", points},
          {"frustum", frustums}};
}

}  // namespace digest
