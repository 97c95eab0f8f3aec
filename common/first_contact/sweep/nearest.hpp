#pragma once
#include <optional>
#include <span>

#include "first_contact/sweep/moved_out.hpp"

/// \file
/// Is a touched edge or vertex the nearest of the surface around it? On a ridge it is; in a valley one of the
/// two faces is nearer, so that the edge needs no test (paper, figure 8). These functions decide it, up to
/// the rounding of the touch.

namespace first_contact {

/// A face at a touched edge or vertex, and the direction within the face in which it leaves the edge at a
/// right angle (not used for a vertex). Not of unit length.
struct FaceAround {
  /// The face.
  const Facet* facet;
  /// The direction.
  Vector inward;
};

/// A touch of an edge, as the faces at that edge make it: nothing if one of them is nearer to the centre; the
/// touch of a face if the normals agree, so that a floor of many triangles is a floor; or else the touch of
/// an edge that it is.
std::optional<Touch> among_faces(Touch touch, std::span<const FaceAround> faces,
                                 const Moving<Sphere>& moving);

/// A touch of a vertex, as the edges that leave it (given as vectors) and its faces make it: nothing if an
/// edge is nearer to the centre; the touch of a face or of an edge if the normals agree; or else the touch of
/// a vertex that it is.
std::optional<Touch> among_edges(Touch touch, std::span<const Vector> edges,
                                 std::span<const FaceAround> faces, const Moving<Sphere>& moving);

}  // namespace first_contact
