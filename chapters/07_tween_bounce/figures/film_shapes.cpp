#include "film_shapes.hpp"

#include <cmath>
#include <numbers>

#include "first_contact/motion/squash.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

namespace tween_bounce {

namespace {

constexpr int round = 36, half_round = 10;  // corners of a ball's outline, and of a line upon it

/// From the body as it stands about the origin to where and how it is drawn.
struct Drawn {
  Eigen::Matrix3d squashed;
  Point middle;

  Point operator()(const Vector& v) const { return middle + squashed * v; }
};

// It stands on its lowest point, however tall it is.
Drawn drawn(const Frame& frame, double reach_down) {
  const Vector up(0, 0, 1);
  return {squash(up, frame.scale), frame.place + (frame.scale - 1) * reach_down * up};
}

// The outline of a squashed ball: its points farthest out in each direction of the picture.
std::vector<Point> outline_of(const Drawn& at, double radius, const View& view) {
  std::vector<Point> outline;
  for (int i = 0; i < round; ++i) {
    const double a = 2 * std::numbers::pi * i / round;
    const Vector towards = std::cos(a) * view.right() + std::sin(a) * view.up();
    outline.push_back(at(radius * normalized(at.squashed * towards)));
  }
  return outline;
}

// The half that one sees of the circle around a ball, at right angles to an axis.
std::vector<Point> belt_of(const Drawn& at, double radius, const Vector& axis, const Vector& eye) {
  const Vector level = axis.cross(eye);
  const Vector across = level.norm() > 1e-6 ? normalized(level) : Vector(axis.unitOrthogonal());
  const Vector front = across.cross(axis);
  std::vector<Point> belt;
  for (int i = 0; i <= half_round; ++i) {
    const double a = std::numbers::pi * i / half_round;
    belt.push_back(at(radius * (std::cos(a) * across + std::sin(a) * front)));
  }
  return belt;
}

Shape shape_of_ball(double radius, const Frame& frame, const View& view) {
  const Drawn at = drawn(frame, radius);
  const Eigen::Matrix3d turn = frame.turn.toRotationMatrix();
  return {{{outline_of(at, radius, view), colour::orange}},
          {belt_of(at, radius, turn.col(0), view.eye()), belt_of(at, radius, turn.col(2), view.eye())}};
}

Shape shape_of_box(const Box& box, const Frame& frame, const View& view) {
  static constexpr const Colour* colours[]{&colour::amber, &colour::orange, &colour::yellow};
  const Box turned = Rigid(Quaternion(frame.turn.coeffs()), Vector::Zero()).box(box);
  const Drawn at = drawn(frame, turned.effective_radius({0, 0, 1}));
  const auto corners = turned.vertices();
  Shape shape;
  for (unsigned axis = 0; axis < 3; ++axis)
    for (const bool positive : {false, true}) {
      const unsigned base = positive ? 1U << axis : 0, u = 1U << (axis + 1) % 3, v = 1U << (axis + 2) % 3;
      Face face{{}, *colours[axis]};
      const Point a = at(corners[base]), b = at(corners[base + u]), d = at(corners[base + v]);
      if ((positive ? 1 : -1) * (b - a).cross(d - a).dot(view.eye()) > 0)
        face.corners = {a, b, at(corners[base + u + v]), d};
      shape.faces.push_back(std::move(face));
    }
  return shape;
}

// What of a polygon is on a plane's side, by Sutherland and Hodgman's walk round it.
std::vector<Point> cut(const std::vector<Point>& polygon, const Vector& normal, double offset) {
  std::vector<Point> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double at_a = normal.dot(a) + offset, at_b = normal.dot(b) + offset;
    if (at_a >= 0) kept.push_back(a);
    if ((at_a >= 0) != (at_b >= 0)) kept.push_back(a + at_a / (at_a - at_b) * (b - a));
  }
  return kept;
}

}  // namespace

Shape shape_of(const Actor& actor, const Frame& frame, const View& view) {
  if (const Sphere* ball = std::get_if<Sphere>(&actor)) return shape_of_ball(ball->radius, frame, view);
  return shape_of_box(std::get<Box>(actor), frame, view);
}

double reach_of(const Actor& actor) {
  if (const Sphere* ball = std::get_if<Sphere>(&actor)) return ball->radius;
  const Box& box = std::get<Box>(actor);
  return (box.r + box.s + box.t).norm() / 2;
}

std::vector<Point> piece_of(const Plane& plane, const Eigen::AlignedBox3d& room,
                            const std::vector<Wall>& walls, const Point& side) {
  const double size = room.sizes().norm(), hair = 1e-9 * (size + room.center().norm());
  const Vector n = plane.normal(), u = n.unitOrthogonal(), v = n.cross(u);
  const Point middle = room.center() - (n.dot(room.center()) + plane.offset()) * n;
  std::vector<Point> piece{middle - size * u - size * v, middle + size * u - size * v,
                           middle + size * u + size * v, middle - size * u + size * v};
  for (int axis = 0; axis < 3; ++axis) {
    piece = cut(piece, Vector::Unit(axis), hair - room.min()[axis]);
    piece = cut(piece, -Vector::Unit(axis), hair + room.max()[axis]);
  }
  for (const Wall& wall : walls)
    if (const Plane* other = std::get_if<Plane>(&wall); other && other != &plane) {
      const double sign = other->normal().dot(side) + other->offset() < 0 ? -1 : 1;
      piece = cut(piece, sign * other->normal(), hair + sign * other->offset());
    }
  return piece;
}

}  // namespace tween_bounce
