#include "first_contact/sweep/nearest.hpp"

#include <algorithm>
#include <cmath>

namespace first_contact {

namespace {

/// How far a point may go along a tangent of the sphere before it is a rounding error away from it: a step s
/// leads from distance d to sqrt(d^2 + s^2) <= d + tolerance.
double unnoticed_step(const Touch& touch) {
  return std::sqrt(touch.tolerance * (2 * touch.distance + touch.tolerance));
}

/// Does the surface that leaves the touched point in this direction come nearer to the centre?
bool nearer_along(const Touch& touch, const Vector& direction) {
  return touch.distance * touch.normal.dot(direction) > unnoticed_step(touch) * direction.norm();
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

/// The same touch with the face's own normal, if the face is approached; sliding along a face is no contact.
std::optional<Touch> as_touch_of_face(Touch touch, const Facet& facet, const Moving<Sphere>& moving) {
  const double side = touch.normal.dot(facet.normal) > 0 ? 1 : -1;
  if (!(side * facet.normal.dot(moving.displacement) < 0)) return std::nullopt;
  touch.normal = side * facet.unit_normal();
  touch.feature = Feature::face;
  return touch;
}

/// The face whose normal agrees best with the touch; none if none does.
const Facet* face_that_agrees(const Touch& touch, std::span<const FaceAround> faces, double radius) {
  const Facet* best = nullptr;
  double least = 2;
  for (const auto& [facet, inward] : faces) {
    if (facet->thin_for(radius)) continue;
    const double sine = touch.normal.cross(facet->unit_normal()).norm();
    if (sine >= least || !agree(touch, sine)) continue;
    least = sine;
    best = facet;
  }
  return best;
}

}  // namespace

//! [among_faces]
std::optional<Touch> among_faces(const Touch& edge, std::span<const FaceAround> faces,
                                 const Moving<Sphere>& moving) {
  for (const auto& [facet, inward] : faces)
    if (!facet->thin_for(moving.shape.radius) && nearer_along(edge, inward)) return std::nullopt;
  if (const Facet* facet = face_that_agrees(edge, faces, moving.shape.radius))
    return as_touch_of_face(edge, *facet, moving);
  return edge;
}
//! [among_faces]

//! [among_edges]
std::optional<Touch> among_edges(const Touch& vertex, std::span<const Vector> edges,
                                 std::span<const FaceAround> faces, const Moving<Sphere>& moving) {
  for (const Vector& e : edges)
    if (nearer_along(vertex, e)) return std::nullopt;
  if (const Facet* facet = face_that_agrees(vertex, faces, moving.shape.radius))
    return as_touch_of_face(vertex, *facet, moving);
  for (const Vector& e : edges) {
    if (!agree(vertex, std::abs(vertex.normal.dot(e)) / e.norm())) continue;
    const Vector m = moving.shape.center - vertex.point;
    if (!(e.cross(m).dot(e.cross(moving.displacement)) < 0)) return std::nullopt;  // sliding along the edge
    Touch touch = vertex;
    touch.feature = Feature::edge;
    return touch;
  }
  return vertex;
}
//! [among_edges]

}  // namespace first_contact
