#pragma once
#include "first_contact/geometry/plane.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/sweep/obstacle.hpp"

namespace first_contact {

/// Do the sphere and the plane share a point? |E.S| <= r (paper, 1.2). Touching counts.
bool overlap(const Sphere& sphere, const Plane& plane);

/// First contact of a moving sphere with a plane (paper, 1.2): the centre meets the plane moved out by the
/// radius, E' = [N, D - r], at t = -(E'.S0) / (N.V). The plane has two sides: the one where the centre starts
/// counts.
///
/// The point of the contact is C = S(t) - r N (paper, 1.2); of an overlap, the foot of the centre on the
/// plane.
///
/// Error of t: at most 8 eps (|S0| + |D| + r + t |V|) / |N.V|. The last term is there for motions that are
/// nearly parallel to a plane that is not: N.V is then a small difference of large products.
///
/// \see error_of_time, tests/oracle/sphere_plane.cpp
std::optional<Contact> sweep(const Moving<Sphere>& moving, const Plane& plane);

}  // namespace first_contact
