#pragma once
#include <cmath>
#include <limits>

#include "first_contact/geometry/box.hpp"
#include "first_contact/geometry/plane.hpp"
#include "first_contact/geometry/sphere.hpp"

/// \file
/// How well the time of a contact with a plane is known: the bound that the sweeps of a sphere and of a box
/// state, and to which their tests hold them.

namespace first_contact {

//! [plane_error]
/// The lengths from which rounding comes: |S0| + |D| + r.
inline double lengths_of(const Sphere& sphere, const Plane& plane) {
  return norm(sphere.center) + std::abs(plane.offset()) + sphere.radius;
}

/// The same for a box, with half of its axes in place of the radius.
inline double lengths_of(const Box& box, const Plane& plane) {
  return norm(box.center) + std::abs(plane.offset()) + 0.5 * (norm(box.r) + norm(box.s) + norm(box.t));
}

/// By how much the time t of a contact may be wrong: 8 eps (lengths + t |V|) / |N.V|.
/// \param lengths  of the scene, as above
/// \param way  t |V|, the length of the way to the contact
/// \param approach  N.V, as exactly as it is known
template <class Number>
Number error_of_time(const Number& lengths, const Number& way, const Number& approach) {
  using std::abs;
  return 8 * std::numeric_limits<double>::epsilon() * (lengths + way) / abs(approach);
}
//! [plane_error]

}  // namespace first_contact
