#include "rounded.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace first_contact;
using namespace first_contact::figure;

namespace {

constexpr int steps = 7;  // of a quarter circle or so
constexpr double opacity = 0.3;

// The direction between two unit vectors, at equal angles.
Vector between(const Vector& a, const Vector& b, double share) {
  const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
  if (angle == 0) return a;
  return (std::sin((1 - share) * angle) * a + std::sin(share * angle) * b) / std::sin(angle);
}

// A small face of the rounded solid, if it looks at the eye.
void patch(Scene& scene, const std::vector<Point>& corners, const Vector& normal, const Colour& colour,
           const View& view, int layer) {
  if (normal.dot(view.eye()) > 0) scene.polygon(corners, {colour, opacity, true}, layer);
}

// The quarter cylinder about an edge, from the normal of one face to that of the other.
void draw_cylinder(Scene& scene, const Point& a, const Point& b, const Vector& n, const Vector& m, double r,
                   const View& view, int layer) {
  for (int i = 0; i < steps; ++i) {
    const Vector p = between(n, m, double(i) / steps), q = between(n, m, double(i + 1) / steps);
    patch(scene, {a + r * p, b + r * p, b + r * q, a + r * q}, p + q, colour::green, view, layer);
  }
}

// The normals of the faces at a vertex, each once, in their order around it.
std::vector<Vector> normals_around(const Environment& solid, std::uint32_t vertex) {
  std::vector<Vector> normals;
  Vector middle = Vector::Zero();
  for (const std::uint32_t face : solid.topology().faces_at(vertex)) {
    const Vector n = solid.facet(face).unit_normal();
    const bool known =
        std::any_of(normals.begin(), normals.end(), [&](const Vector& m) { return m.dot(n) > 0.999; });
    if (known) continue;
    normals.push_back(n);
    middle += n;
  }
  const Vector u = middle.unitOrthogonal(), v = middle.normalized().cross(u);
  std::sort(normals.begin(), normals.end(), [&](const Vector& a, const Vector& b) {
    return std::atan2(a.dot(v), a.dot(u)) < std::atan2(b.dot(v), b.dot(u));
  });
  return normals;
}

// The part of the ball about a vertex between the normals around it, as triangles with a corner in their
// middle.
void draw_ball(Scene& scene, const Point& vertex, const std::vector<Vector>& normals, double r,
               const View& view, int layer) {
  Vector middle = Vector::Zero();
  for (const Vector& n : normals) middle += n;
  middle.normalize();
  for (std::size_t k = 0; k < normals.size(); ++k) {
    const Vector &n = normals[k], &m = normals[(k + 1) % normals.size()];
    for (int i = 0; i < steps; ++i)
      for (int j = 0; j < steps; ++j) {
        const auto direction = [&](int a, int b) {
          return between(middle, between(n, m, double(a) / steps), double(b) / steps);
        };
        const Vector p = direction(i, j), q = direction(i, j + 1), s = direction(i + 1, j + 1),
                     t = direction(i + 1, j);
        patch(scene, {vertex + r * t, vertex + r * s, vertex + r * q, vertex + r * p}, p + s, colour::amber,
              view, layer);
      }
  }
}

}  // namespace

std::vector<Point> rounded_outline(const std::vector<Point>& corners, double r) {
  const auto angle_of_side =
      [&](std::size_t i) {  // of the outward normal of the side that begins at corner i
        const Vector side = corners[(i + 1) % corners.size()] - corners[i % corners.size()];
        return std::atan2(-side.x(), side.y());
      };
  std::vector<Point> outline;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double from = angle_of_side(i + corners.size() - 1);
    const double turn = std::remainder(angle_of_side(i) - from, 2 * std::numbers::pi);
    for (int k = 0; k <= steps; ++k) {
      const double angle = from + turn * k / steps;
      outline.emplace_back(corners[i] + r * Vector(std::cos(angle), std::sin(angle), 0));
    }
  }
  outline.push_back(outline.front());
  return outline;
}

void draw_ridges(Scene& scene, const Environment& environment, const View& view, int layer) {
  const auto& vertices = environment.mesh().vertices();
  for (const auto& edge : environment.topology().edges()) {
    const auto sides = environment.topology().sides(edge);
    const bool seen = std::any_of(sides.begin(), sides.end(), [&](const auto& side) {
      return environment.facet(side.face).normal.dot(view.eye()) > 0;
    });
    if (edge.kind == EdgeKind::flat || (!seen && edge.kind != EdgeKind::boundary)) continue;
    scene.line({vertices[edge.vertices[0]], vertices[edge.vertices[1]]}, {colour::ink, 1.4}, layer);
  }
}

void draw_rounded(Scene& scene, const Environment& solid, double r, const View& view, int layer) {
  for (std::size_t i = 0; i < solid.mesh().size(); ++i) {
    const Vector n = solid.facet(i).unit_normal();
    const Triangle t = solid.mesh().triangle(i);
    patch(scene, {t.a + r * n, t.b + r * n, t.c + r * n}, n, colour::sky, view, layer);
  }
  const auto& vertices = solid.mesh().vertices();
  for (const auto& edge : solid.topology().edges()) {
    const auto sides = solid.topology().sides(edge);
    if (edge.kind == EdgeKind::convex)
      draw_cylinder(scene, vertices[edge.vertices[0]], vertices[edge.vertices[1]],
                    solid.facet(sides[0].face).unit_normal(), solid.facet(sides[1].face).unit_normal(), r,
                    view, layer);
  }
  for (std::uint32_t i = 0; i < vertices.size(); ++i)
    draw_ball(scene, vertices[i], normals_around(solid, i), r, view, layer);
}
