#pragma once
#include "first_contact/bvh/cast/parts.hpp"
#include "first_contact/geometry/sphere.hpp"

namespace first_contact::bvh {

/// Does the sphere share a point with a triangle of the tree?
///
/// The idea: what excludes a box for a cast that stays where it is excludes it here, and of a triangle that is left
/// the plain overlap decides. So the answer is that of a loop over all triangles. It equals the plain tree's, box by
/// box, and is as plain: one child after the other, for the static question is seldom asked by the million.
bool overlap(const Sphere& sphere, const Parts& parts);

}  // namespace first_contact::bvh
