#pragma once
#include <optional>

#include "first_contact/geometry/space.hpp"

namespace first_contact {

/// How a moving point enters a ball.
struct Entry {
  double time;       ///< t in [0, 1]
  Vector direction;  ///< unit, from the ball's centre to the point at that time
};

/// When does the point m + t v enter the ball of radius r about the origin? Nothing if not within t in [0,
/// 1]. A point that starts inside, or on, enters at once if it goes deeper, and never if it leaves. In the
/// centre itself the direction is against the motion.
///
/// This is the first root of |m + t v|^2 = r^2 in a form whose error does not grow with the way: t = c / (-b + sqrt D) with b =
/// m.v, c = m.m - r^2, and D = v.v r^2 - |m x v|^2, which compares r with the closest approach (Ray Tracing
/// Gems, ch. 7).
///
/// \param tolerance  a path that passes by at most this much too far away counts as a path that grazes the
/// ball, where it is closest.
std::optional<Entry> first_root(const Vector& m, const Vector& v, double r, double tolerance);

}  // namespace first_contact
