#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "first_contact/bvh/build/space.hpp"
#include "first_contact/bvh/build/surface.hpp"

namespace first_contact::bvh {

/// How the surface is turned around each vertex: a cone that holds the normals of all triangles there.
///
/// The idea: where a sphere touches a smooth surface its centre is over the touched point, give or take the
/// angle by which the surface bends there. So a part of the surface over which the centre never is, as seen
/// along its normals, need not be looked at, however deep it is in the sphere: from every point of it the
/// surface leads nearer to the centre. It equals asking, feature by feature, what lies around it
/// (nearest.hpp), which a sphere that leaves the ground must do for all that it overlaps and sweeps over.
/// Measured (./course bench --own --sides 707, with cones and without): .22 and .25 of the textbook for a
/// hop, .25 and .37 for an aimed cast.
///
/// Why it is right. Let the normals of all triangles at a vertex v be within the angle theta of an axis n,
/// and let each edge at v have exactly two triangles, which go along it in opposite directions. Then, seen
/// along n, the triangles at v turn all the same way, and so go all the way round: whatever direction u
/// there is at right angles to n, from v and from any point of the edges at v a triangle leads along u + s
/// n with |s| <= tan theta. Let the direction N from such a point to the centre be at an angle phi to n
/// and to -n, and u be where N leans to. Then along this triangle the distance falls, as N.(u + s n) >=
/// sin phi - tan theta cos phi = sin (phi - theta) / cos theta, which is more than 0 if phi > theta. And a
/// face is touched along its own normal. So the height of the centre over a touched point, along n, is at
/// least cos theta of their distance.
///
/// The rounding. Only vertices count whose triangles are not thin: all heights are at least 1/64 of the
/// longest side. So faces answer for themselves (\see Facet::thin_for), their normals are right to 2^-46, and
/// no angle is within 1/16 of a straight one, so that one of the two sides at v is at an angle of at least
/// (phi - theta) / 32 to the tangent of the sphere. With the `margin` that is 2^-10. It is more than what
/// nearest.cpp allows for rounding, 2^-12 at distances of 2^-21 of all lengths or more (Walk::unsure).
class NormalCones {
 public:
  NormalCones(const Surface& surface, const Space& space);

  /// The cosine of the angle within which all normals around some triangles are from an axis, less the
  /// margin; 0 if they have no such cone.
  /// \param axis  of length 1
  /// \param triangles  their numbers
  float cosine_around(const Eigen::Vector3f& axis, std::span<const std::uint32_t> triangles) const;

  /// By how much the cosine is made smaller.
  static constexpr float margin = 1 / 32.0F;

 private:
  /// Of a vertex; the cosine is 0 if it has none.
  struct Cone {
    Eigen::Vector3f axis;
    float cosine, sine;  // of the angle between the axis and its side
  };
  Cone cone_at(std::uint32_t vertex, const std::vector<Eigen::Vector3f>& normals) const;

  const Surface& surface_;
  std::vector<Cone> cones_;
};

}  // namespace first_contact::bvh
