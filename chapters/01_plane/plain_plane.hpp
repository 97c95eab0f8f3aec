#pragma once
#include <cmath>

#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/space.hpp"

/// A plane, as one makes it first: right for a normal that is neither huge nor tiny.

namespace plane_chapter {

//! [plain_plane]
/// [N, D], divided by the length of N.
inline first_contact::Homogeneous plain_plane(const first_contact::Vector& n, double d) {
  const double length = std::sqrt(first_contact::dot(n, n));
  return {n.x() / length, n.y() / length, n.z() / length, d / length};
}
//! [plain_plane]

}  // namespace plane_chapter
