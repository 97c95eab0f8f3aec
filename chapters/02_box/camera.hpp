#pragma once
#include <array>

#include "first_contact/geometry/box.hpp"
#include "first_contact/geometry/transform.hpp"

namespace box_chapter {

/// A camera at the origin that looks along x, with z upwards.
first_contact::Transform camera();

/// The planes of its frustum, as results name them.
inline constexpr std::array<const char*, 6> plane_names{"left", "right", "lower", "upper", "near", "far"};

/// How a box lies to these planes.
struct Seen {
  std::array<double, 6> distance;  ///< E.Q
  std::array<double, 6> radius;    ///< r_eff
  std::array<double, 6> highest;   ///< E.Q + r_eff: below 0 all of the box is behind the plane
  bool rejected;

  /// The plane that it is farthest behind.
  std::size_t worst() const;
};
Seen seen(const first_contact::Box& box);

}  // namespace box_chapter
