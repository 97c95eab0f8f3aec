#pragma once
#include "first_contact/geometry/plane.hpp"
#include "first_contact/sweep/turning_mesh.hpp"

namespace first_contact {

/// First contact of a mesh that turns and moves with a plane: that of a vertex, so that edges and faces need no care.
/// The plane has two sides; the one where the mean of the vertices is at t = 0 counts.
///
/// Found by conservative advancement as for two meshes (turning_mesh.hpp), with the same gap; the scene is the
/// vertices, the way of the hinge and the hinge's distance from the plane. A vertex within the gap is in contact if
/// it comes nearer. What goes along the plane, or stands on it by a vertex about which it turns, is not in contact
/// for that; it sinks in by `gap / 2` at most before it is.
///
/// The points are the vertices within the gap, put on the plane at right angles; if there are more than four, their
/// mean. The feature is theirs: a vertex, an edge of two, or a face.
std::optional<Contact> sweep(const Turning<Mesh>& turning, const Plane& plane, const Closeness& close);
/// The same with `turning_gap` of the scene.
std::optional<Contact> sweep(const Turning<Mesh>& turning, const Plane& plane);
/// First contact of a box that turns with a plane.
inline std::optional<Contact> sweep(const Turning<Box>& turning, const Plane& plane) {
  return sweep(by_surface(turning), plane);
}

}  // namespace first_contact
