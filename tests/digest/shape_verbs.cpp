#include "first_contact/geometry/bounding.hpp"
#include "first_contact/geometry/bounds.hpp"
#include "first_contact/geometry/closest_point.hpp"
#include "first_contact/geometry/frustum.hpp"
#include "first_contact/geometry/line_triangle.hpp"
#include "first_contact/geometry/mesh_edges.hpp"
#include "first_contact/geometry/transform.hpp"
#include "first_contact/geometry/triangle_distance.hpp"
#include "record.hpp"
#include "shapes.hpp"

/// Shapes at rest: distances, overlaps, transforms, what bounds them.
namespace digest {

namespace {

void planes(Record& record) {
  Dice dice(30);
  for (int i = 0; i < cases; ++i, record.next()) {
    const double unit = dice.scale();
    const Plane wall = plane(dice, unit);
    record.add(wall.coefficients());
    record.add(wall.signed_distance(unit * dice.point()));
    record.add(wall.moved_out(unit * dice.length()).offset());
    const Point through = unit * dice.point();
    record.add(Plane::through(through, unit * dice.vector()).coefficients());
  }
}

void distances(Record& record) {
  Dice dice(31);
  for (int i = 0; i < cases; ++i, record.next()) {
    const double unit = dice.scale();
    const Triangle a = triangle(dice, unit), b = triangle(dice, unit);
    const Point p = unit * dice.point();
    record.add(norm(unit * dice.vector()));
    record.add(closest_point(p, a));
    record.add(nearest_points(a, b).distance());
    record.add(weights_where_line_meets(p, dice.vector(), a));
    record.add(a.area_vector());
  }
}

Bounds bounds(Dice& dice, double unit) {
  Bounds box;
  box.extend(Point(unit * dice.point()));
  box.extend(Point(unit * dice.point()));
  return box;
}

void boxes(Record& record) {
  Dice dice(32);
  for (int i = 0; i < cases; ++i, record.next()) {
    const double unit = dice.scale();
    const Bounds a = bounds(dice, unit), b = bounds(dice, unit);
    record.add(overlap(a, b));
    record.add(overlap(triangle(dice, unit), a));
    const Moving<Sphere> mover = ball(dice, unit);
    if (const auto part = passage(mover.shape.center, mover.displacement, a))
      record.add(Vector2(part->enter, part->leave));
    const Bounds around = bounds_of(mover.shape, mover.displacement);
    record.add(around.min());
    record.add(around.max());
  }
}

Matrix matrix(Dice& dice) {
  Matrix m = Matrix::Identity();
  const int rows = dice.one_in(3) ? 4 : 3;
  for (;;) {
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < 4; ++column) m(row, column) = dice.coordinate();
    if (!is_singular(m)) return m;
  }
}

void transforms(Record& record) {
  Dice dice(33);
  for (int i = 0; i < cases; ++i, record.next()) {
    const Transform map(matrix(dice)), other(matrix(dice));
    record.add(map.inverse().matrix());
    record.add(map.after(other).matrix());
    record.add(map.apply(as_point(dice.point())));
    const Rigid motion = turn(dice);
    record.add(motion.rotation());
    record.add(motion.point(dice.point()));
    record.add(motion.inverse().after(motion).translation());
    record.add(motion.plane(plane(dice, 1)).coefficients());
  }
}

void bounding(Record& record) {
  Dice dice(34);
  for (int i = 0; i < cases / 10; ++i, record.next()) {
    const double unit = dice.scale();
    std::vector<Point> points;
    for (int n = dice.whole(1, 20); n > 0; --n) points.push_back(unit * dice.point());
    const Sphere sphere = bounding_sphere(points);
    record.add(sphere.center);
    record.add(sphere.radius);
    const Box box = bounding_box(points);
    record.add(box.center);
    record.add(box.r);
    record.add(volume(box));
    record.add(volume(sphere));
  }
}

void edges(Record& record) {
  Dice dice(35);
  for (int i = 0; i < cases / 100; ++i, record.next()) {
    const int n = dice.whole(1, 6);
    const Mesh mesh = ground(dice, n, dice.scale());
    const MeshEdges topology(mesh);
    for (const MeshEdges::Edge& edge : topology.edges()) record.count(static_cast<std::size_t>(edge.kind));
    for (std::uint32_t v = 0; v < mesh.vertices().size(); ++v) record.add(topology.buried(v));
  }
}

}  // namespace

std::vector<Verb> shape_verbs() {
  return {{"planes", planes},         {"distances", distances}, {"boxes", boxes},
          {"transforms", transforms}, {"bounding", bounding},   {"edges", edges}};
}

}  // namespace digest
