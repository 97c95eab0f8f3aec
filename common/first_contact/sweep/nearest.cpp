#include "first_contact/sweep/nearest.hpp"

#include <algorithm>
#include <cmath>

#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/unit_scale.hpp"

namespace first_contact {

namespace {

/// How far a point may go along a tangent of the sphere before it is a rounding error away from it: a step s
/// leads from distance d to sqrt(d^2 + s^2) <= d + tolerance.
double unnoticed_step(const Touch& touch) {
  const double square = touch.tolerance * (2 * touch.distance + touch.tolerance);
  if (is_ordinary_square(square)) return std::sqrt(square);
  const double unit = unit_scale(touch.distance + touch.tolerance);
  return std::sqrt(unit * touch.tolerance * (unit * (2 * touch.distance + touch.tolerance))) / unit;
}

/// Does the surface that leaves the touched point in this direction come nearer to the centre?
bool nearer_along(const Touch& touch, const Vector& direction) {
  const double step = unnoticed_step(touch), unnoticed = step * norm(direction);
  if (is_ordinary_square(unnoticed)) return touch.distance * dot(touch.normal, direction) > unnoticed;
  const double unit = unit_scale(touch.distance + step);
  const Vector way = unit_scale(largest(direction)) * direction;
  return unit * touch.distance * dot(touch.normal, way) > unit * step * norm(way);
}

/// Nearer than this many rounding errors, what is left of a distance has no direction of its own (the step
/// above would be a quarter of it); the normal is then against the motion, as sure as any product of two
/// vectors.
constexpr double rounding_errors_of_a_direction = 33;

/// Is the angle between the normal and the face's, whose sine this is, no more than rounding?
bool agree(const Touch& touch, double sine) {
  const bool near = touch.distance < rounding_errors_of_a_direction * touch.tolerance;
  return near ? sine <= rounding_of_distance : touch.distance * sine <= unnoticed_step(touch);
}

/// What the flat surroundings of a touch make of it. Sliding along them is no contact.
enum class Verdict { none_agrees, sliding, approached };

/// Turns a touch into that of a face whose normal agrees with its own; of several the one that agrees best.
Verdict ask_faces(Touch& touch, std::span<const FaceAround> faces, const Moving<Sphere>& moving) {
  Verdict verdict = Verdict::none_agrees;
  const Vector normal = touch.normal;
  double least = 2;
  for (const auto& [facet, inward] : faces) {
    const double sine = norm(normal.cross(facet->unit_normal()));
    if (facet->thin_for(moving.shape.radius) || !agree(touch, sine)) continue;
    if (verdict == Verdict::none_agrees) verdict = Verdict::sliding;
    const double side = dot(normal, facet->normal) > 0 ? 1 : -1;
    if (!(side * dot(facet->normal, moving.displacement) < 0) || sine >= least) continue;
    verdict = Verdict::approached;
    least = sine;
    touch.normal = side * facet->unit_normal();
    touch.feature = Feature::face;
  }
  return verdict;
}

/// Is a turn about e from m towards V one away from m? Only the three directions matter.
bool turns_back(const Vector& e, const Vector& m, const Vector& v) {
  const double turn = dot(e.cross(m), e.cross(v));
  if (is_ordinary_square(turn)) return turn < 0;
  const Vector axis = unit_scale(largest(e)) * e;
  return dot(axis.cross(unit_scale(largest(m)) * m), axis.cross(unit_scale(largest(v)) * v)) < 0;
}

/// Turns the touch of a vertex into that of an edge which is at a right angle to its normal.
Verdict ask_edges(Touch& touch, std::span<const Vector> edges, const Moving<Sphere>& moving) {
  Verdict verdict = Verdict::none_agrees;
  const Vector m = moving.shape.center - touch.point;
  for (const Vector& e : edges) {
    if (!agree(touch, std::abs(dot(touch.normal, e)) / norm(e))) continue;
    touch.feature = Feature::edge;
    if (turns_back(e, m, moving.displacement)) return Verdict::approached;
    verdict = Verdict::sliding;
  }
  return verdict;
}

}  // namespace

//! [among_faces]
std::optional<Touch> among_faces(Touch touch, std::span<const FaceAround> faces,
                                 const Moving<Sphere>& moving) {
  for (const auto& [facet, inward] : faces)
    if (!facet->thin_for(moving.shape.radius) && nearer_along(touch, inward)) return std::nullopt;
  if (ask_faces(touch, faces, moving) == Verdict::sliding) return std::nullopt;
  return touch;
}
//! [among_faces]

//! [among_edges]
std::optional<Touch> among_edges(Touch touch, std::span<const Vector> edges,
                                 std::span<const FaceAround> faces, const Moving<Sphere>& moving) {
  for (const Vector& e : edges)
    if (nearer_along(touch, e)) return std::nullopt;
  Verdict verdict = ask_faces(touch, faces, moving);
  if (verdict == Verdict::none_agrees) verdict = ask_edges(touch, edges, moving);
  if (verdict == Verdict::sliding) return std::nullopt;
  return touch;
}
//! [among_edges]

}  // namespace first_contact
