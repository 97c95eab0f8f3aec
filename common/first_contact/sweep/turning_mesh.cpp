#include "first_contact/sweep/turning_mesh.hpp"

#include <algorithm>
#include <vector>

#include "first_contact/geometry/closest_point.hpp"
#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/transform.hpp"
#include "first_contact/geometry/triangle_distance.hpp"
#include "first_contact/geometry/unit_scale.hpp"
#include "first_contact/sweep/course.hpp"

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

// How fast each triangle is at most: as its corner that is farthest from the axis.
std::vector<double> speeds(const Turning<Mesh>& turning) {
  std::vector<double> all;
  const auto from_axis = [&](const Point& p) { return norm(turning.axis.cross(p - turning.center)); };
  for (std::size_t i = 0; i < turning.shape.size(); ++i) {
    const Triangle t = turning.shape.triangle(i);
    const double reach = std::max({from_axis(t.a), from_axis(t.b), from_axis(t.c)});
    all.push_back(norm(turning.displacement) + std::abs(turning.angle) * reach);
  }
  return all;
}

double scale_of(const Turning<Mesh>& turning, const Mesh& obstacle) {
  double largest = norm(turning.displacement);
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

/// The two meshes as they are now, and what is known of the motion.
struct Scene {
  const Turning<Mesh>& turning;
  const Mesh& obstacle;
  std::vector<double> speed;
  std::vector<Ball> obstacle_balls;
  Closeness close;
  double scale;
};

/// How long it may go on from where it is, or what it touches there.
struct Advance {
  double time;
  std::optional<NearestPoints> touch = std::nullopt;
  std::size_t triangle = no_triangle;
};

// Two triangles within the gap: nothing if they come nearer, or else for how long they surely are not deep.
std::optional<double> leaving_time(const Scene& scene, double now, const Triangle& mover,
                                   const NearestPoints& pair) {
  const double distance = pair.distance();
  if (scene.close.also_leaving || distance <= turning_touch * scene.scale) return std::nullopt;
  const Vector normal = normalized(pair.first - pair.second);
  const Going going(scene.turning, now);
  const double known = going.speed_of({mover.a, mover.b, mover.c}) * 0x1p-48 * scene.scale / distance;
  double time = 1;
  for (const Point& p : {mover.a, mover.b, mover.c}) {
    const Course course = going.of(p, normal, pair.second);
    if (course.height <= scene.close.gap && course.rate < -known) return std::nullopt;
    time = std::min(time, time_above(course.height <= scene.close.gap ? -scene.close.gap / 2 : 0, course));
  }
  return time;
}

//! [safe_turn]
// Of all pairs of triangles, the least time before which they cannot meet.
Advance safe_turn(const Scene& scene, double now) {
  const Mesh mover = turned(scene.turning, now);
  Advance least{1 - now};
  for (std::size_t i = 0; i < mover.size(); ++i) {
    const Triangle triangle = mover.triangle(i);
    const Ball ball(triangle);
    for (std::size_t j = 0; j < scene.obstacle.size(); ++j) {
      const Ball& other = scene.obstacle_balls[j];
      const double room = norm(ball.center - other.center) - ball.radius - other.radius;
      if (room > scene.close.gap && room - scene.close.gap / 2 >= least.time * scene.speed[i])
        continue;  // too far to matter
      const NearestPoints pair = nearest_points(triangle, scene.obstacle.triangle(j));
      const double distance = pair.distance();
      const auto time = distance > scene.close.gap
                            ? std::optional((distance - scene.close.gap / 2) / scene.speed[i])
                            : leaving_time(scene, now, triangle, pair);
      if (!time) return {0, pair, j};
      least.time = std::min(least.time, *time);
    }
  }
  return least;
}
//! [safe_turn]

Contact contact_of(const Scene& scene, double time, const Advance& at) {
  const auto& [mover, obstacle] = *at.touch;
  const Vector forwards = Going(scene.turning, time).velocity(mover);
  const Vector normal = mover != obstacle ? Vector(mover - obstacle) : Vector(-forwards);
  const Feature feature = feature_at(obstacle, scene.obstacle.triangle(at.triangle), scene.close.gap);
  return {time, only(obstacle), normalized(normal), feature, at.triangle};
}

}  // namespace

Mesh turned(const Turning<Mesh>& turning, double t) {
  const Rigid turn = Rigid::turned(turning.axis, t * turning.angle);
  const Point hinge = turning.center + t * turning.displacement;
  std::vector<Point> vertices;
  for (const Point& p : turning.shape.vertices())
    vertices.push_back(hinge + turn.direction(p - turning.center));
  return {std::move(vertices), turning.shape.faces()};
}

Mesh scaled(const Mesh& mesh, double unit) {
  std::vector<Point> vertices;
  for (const Point& p : mesh.vertices()) vertices.push_back(unit * p);
  return {std::move(vertices), mesh.faces()};
}

Mesh surface_of(const Box& box) {
  const auto corners = box.vertices();
  std::vector<Mesh::Face> faces{{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  if (dot(box.r.cross(box.s), box.t) < 0)
    for (auto& [a, b, c] : faces) std::swap(b, c);
  return {{corners.begin(), corners.end()}, std::move(faces)};
}

//! [sweep_turning]
std::optional<Contact> sweep(const Turning<Mesh>& turning, const Mesh& obstacle, const Closeness& close) {
  if (turning.angle == 0 && turning.displacement.isZero(0)) return std::nullopt;
  const Scene scene{
      turning, obstacle, speeds(turning), balls_about(obstacle), close, scale_of(turning, obstacle)};
  for (double time = 0;;) {
    const Advance next = safe_turn(scene, time);
    if (next.touch) return contact_of(scene, time, next);
    if (time >= 1) return std::nullopt;
    time = std::min(1.0, time + next.time);
  }
}
//! [sweep_turning]

std::optional<Contact> sweep(const Turning<Mesh>& turning, const Mesh& obstacle) {
  const double size = scale_of(turning, obstacle), unit = unit_scale(size, largest(turning.center));
  if (is_ordinary(size) || !is_ordinary(unit * size)) return sweep(turning, obstacle, {turning_gap * size});
  const Turning<Mesh> moderate{scaled(turning.shape, unit), unit * turning.center, turning.axis,
                               turning.angle, unit * turning.displacement};
  auto contact = sweep(moderate, scaled(obstacle, unit), {turning_gap * (unit * size)});
  if (contact) contact->points /= unit;
  return contact;
}

}  // namespace first_contact
