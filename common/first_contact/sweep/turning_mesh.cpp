#include "first_contact/sweep/turning_mesh.hpp"

#include <algorithm>
#include <array>
#include <limits>
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

Point highest(const Triangle& triangle, const Vector& normal) {
  Point most = triangle.a;
  for (const Point& p : {triangle.b, triangle.c})
    if (dot(normal, p - most) > 0) most = p;
  return most;
}

/// What lies between two triangles that do not cross: no corner of the obstacle's is above the base.
struct Slab {
  Slab(const Vector& unit_normal, const Triangle& mover, const Triangle& obstacle)
      : normal(unit_normal), base(highest(obstacle, normal)) {
    thickness = dot(normal, highest(mover, -normal) - base);
  }

  Vector normal;
  Point base;
  double thickness = 0;
};

std::array<Vector, 3> edges(const Triangle& t) { return {t.b - t.a, t.c - t.b, t.a - t.c}; }

// A slab is thicker than another if it is by more than this part of the scene: twice what a difference of two points and
// its product with a normal round, 2 eps each.
constexpr double rounding_of_slab = 8 * std::numeric_limits<double>::epsilon();

// The thickest slab lies across the nearest points. Where these are so near that their difference has lost its digits,
// it is found by the normals of the two faces, and those of an edge of each; of two that are parallel, by what of the
// difference is at right angles to them.
Slab slab_between(const Triangle& mover, const Triangle& obstacle, const NearestPoints& pair, double scale) {
  const Vector across = normalized(pair.first - pair.second);
  Slab best(across, mover, obstacle);
  if (pair.distance() > 0x1p-12 * scale) return best;
  const auto offer = [&](const Vector& vector) {
    if (vector.isZero(0)) return;
    const Slab slab(normalized(dot(vector, across) < 0 ? Vector(-vector) : vector), mover, obstacle);
    if (slab.thickness > best.thickness + rounding_of_slab * scale) best = slab;
  };
  offer(mover.area_vector());
  offer(obstacle.area_vector());
  for (const Vector& edge : edges(mover))
    for (const Vector& other : edges(obstacle)) {
      const Vector normal = edge.cross(other);
      const bool parallel = norm(normal) <= 0x1p-20 * norm(edge) * norm(other);
      offer(parallel ? Vector(edge.cross(across).cross(edge)) : normal);
    }
  return best;
}

// Two triangles within the gap: nothing if they come nearer, or else for how long they surely are not deep.
std::optional<double> leaving_time(const Scene& scene, double now, const Triangle& mover,
                                   const Triangle& obstacle, const NearestPoints& pair) {
  const double distance = pair.distance();
  if (scene.close.also_leaving || distance <= turning_touch * scene.scale) return std::nullopt;
  const Slab slab = slab_between(mover, obstacle, pair, scene.scale);
  const Going going(scene.turning, now);
  const double known = going.speed_of({mover.a, mover.b, mover.c}) * 0x1p-48 * scene.scale / distance;
  double time = 1;
  for (const Point& p : {mover.a, mover.b, mover.c}) {
    const Course course = going.of(p, slab.normal, slab.base);
    const bool near = course.height <= scene.close.gap;
    if (course.height <= -scene.close.gap / 4 || (near && course.rate < -known)) return std::nullopt;
    time = std::min(time, time_above(near ? -scene.close.gap / 2 : 0, course));
  }
  return time;
}

// Two triangles farther apart than the gap: for how long they surely stay half of it apart. By their distance, and how
// fast the mover may be; or by the slab that lies between them, which what goes along it does not cross (Mirtich 1996).
double apart_time(const Scene& scene, double now, double speed, const Triangle& mover,
                  const Triangle& obstacle, const NearestPoints& pair) {
  const double level = scene.close.gap / 2, by_speed = (pair.distance() - level) / speed;
  const Slab slab = slab_between(mover, obstacle, pair, scene.scale);
  const Going going(scene.turning, now);
  double by_slab = 1;
  for (const Point& p : {mover.a, mover.b, mover.c}) {
    const Course course = going.of(p, slab.normal, slab.base);
    if (!(course.height > level)) return by_speed;
    by_slab = std::min(by_slab, time_above(level, course));
  }
  return std::max(by_speed, by_slab);
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
      const Triangle obstacle = scene.obstacle.triangle(j);
      const NearestPoints pair = nearest_points(triangle, obstacle);
      const auto time = pair.distance() > scene.close.gap
                            ? apart_time(scene, now, scene.speed[i], triangle, obstacle, pair)
                            : leaving_time(scene, now, triangle, obstacle, pair);
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
    vertices.emplace_back(hinge + turn.direction(p - turning.center));
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
