#include "first_contact/sweep/turning_mesh.hpp"

#include <algorithm>
#include <vector>

#include "first_contact/geometry/closest_point.hpp"
#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/transform.hpp"
#include "first_contact/geometry/triangle_distance.hpp"
#include "first_contact/geometry/unit_scale.hpp"

namespace first_contact {
namespace {

/// A ball about a triangle, to see at a glance that another is far away.
struct Ball {
  explicit Ball(const Triangle& t) : center((t.a + t.b + t.c) / 3) {
    radius = std::max({norm(t.a - center), norm(t.b - center), norm(t.c - center)});
  }

  Point center;
  double radius = 0;
};

std::vector<Ball> balls_about(const Mesh& mesh) {
  std::vector<Ball> balls;
  for (std::size_t i = 0; i < mesh.size(); ++i) balls.emplace_back(mesh.triangle(i));
  return balls;
}

// How far each triangle reaches from the axis: as far as its farthest corner.
std::vector<double> reaches(const Turning<Mesh>& turning) {
  std::vector<double> reach;
  const auto from_axis = [&](const Point& p) { return norm(turning.axis.cross(p - turning.center)); };
  for (std::size_t i = 0; i < turning.shape.size(); ++i) {
    const Triangle t = turning.shape.triangle(i);
    reach.push_back(std::max({from_axis(t.a), from_axis(t.b), from_axis(t.c)}));
  }
  return reach;
}

double scale_of(const Turning<Mesh>& turning, const Mesh& obstacle) {
  double largest = 0;
  for (const Mesh* mesh : {&turning.shape, &obstacle})
    for (const Point& p : mesh->vertices()) largest = std::max(largest, norm(p - turning.center));
  return largest;
}

Feature feature_at(const Point& p, const Triangle& t, double near) {
  for (const Point& corner : {t.a, t.b, t.c})
    if (norm(p - corner) <= near) return Feature::vertex;
  for (const auto& [from, to] : {std::pair(t.a, t.b), std::pair(t.b, t.c), std::pair(t.c, t.a)})
    if (norm(p - closest_point(p, from, to)) <= near) return Feature::edge;
  return Feature::face;
}

/// How far it may turn from where it is, or what it touches there.
struct Advance {
  double angle;
  std::optional<NearestPoints> touch = std::nullopt;
  std::size_t triangle = no_triangle;
};

//! [safe_turn]
// Of all pairs of triangles, the least angle before which they cannot meet.
Advance safe_turn(const Mesh& mover, const std::vector<double>& reach, const Mesh& obstacle,
                  const std::vector<Ball>& obstacle_balls, double most, double gap) {
  Advance least{most};
  for (std::size_t i = 0; i < mover.size(); ++i) {
    const Triangle triangle = mover.triangle(i);
    const Ball ball(triangle);
    for (std::size_t j = 0; j < obstacle.size(); ++j) {
      const Ball& other = obstacle_balls[j];
      const double room = norm(ball.center - other.center) - ball.radius - other.radius;
      if (room > gap && room >= least.angle * reach[i]) continue;  // too far to matter
      const NearestPoints pair = nearest_points(triangle, obstacle.triangle(j));
      const double distance = pair.distance();
      if (distance <= gap) return {0, pair, j};
      least.angle = std::min(least.angle, distance / reach[i]);
    }
  }
  return least;
}
//! [safe_turn]

Contact contact_of(const Turning<Mesh>& turning, double time, const Advance& at, const Triangle& triangle,
                   double gap) {
  const auto& [mover, obstacle] = *at.touch;
  const Vector forwards = turning.angle * turning.axis.cross(mover - turning.center);
  const Vector normal = mover != obstacle ? Vector(mover - obstacle) : Vector(-forwards);
  return {time, only(obstacle), normalized(normal), feature_at(obstacle, triangle, gap), at.triangle};
}

}  // namespace

Mesh turned(const Turning<Mesh>& turning, double t) {
  const Rigid turn = Rigid::turned(turning.axis, t * turning.angle);
  std::vector<Point> vertices;
  for (const Point& p : turning.shape.vertices())
    vertices.push_back(turning.center + turn.direction(p - turning.center));
  return {std::move(vertices), turning.shape.faces()};
}

namespace {

Mesh scaled(const Mesh& mesh, double unit) {
  std::vector<Point> vertices;
  for (const Point& p : mesh.vertices()) vertices.push_back(unit * p);
  return {std::move(vertices), mesh.faces()};
}

}  // namespace

//! [sweep_turning]
std::optional<Contact> sweep(const Turning<Mesh>& turning, const Mesh& obstacle) {
  if (const double size = scale_of(turning, obstacle), unit = unit_scale(size, largest(turning.center));
      !is_ordinary(size) && is_ordinary(unit * size)) {
    Turning<Mesh> moderate = turning;
    moderate.shape = scaled(turning.shape, unit);
    moderate.center *= unit;
    auto contact = sweep(moderate, scaled(obstacle, unit));
    if (contact) contact->points /= unit;
    return contact;
  }
  const std::vector<double> reach = reaches(turning);
  const std::vector<Ball> obstacle_balls = balls_about(obstacle);
  const double gap = turning_gap * scale_of(turning, obstacle), whole = std::abs(turning.angle);
  if (whole == 0) return std::nullopt;
  for (double angle = 0;;) {
    const Mesh mover = turned(turning, angle / whole);
    const Advance next = safe_turn(mover, reach, obstacle, obstacle_balls, whole - angle, gap);
    if (next.touch) return contact_of(turning, angle / whole, next, obstacle.triangle(next.triangle), gap);
    if (angle + next.angle >= whole && angle >= whole) return std::nullopt;
    angle = std::min(whole, angle + next.angle);
  }
}
//! [sweep_turning]

}  // namespace first_contact
