#pragma once
#include "first_contact/geometry/plane.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/sweep/contact.hpp"

namespace first_contact {

/// Do the sphere and the plane share a point? |E.S| <= r (paper, 1.2). Touching counts.
bool overlap(const Sphere& sphere, const Plane& plane);

/// First contact of a moving sphere with a plane (paper, 1.2): the centre meets the plane moved out by the radius,
/// E' = [N, D - r], at t = -(E'.S0) / (N.V). The plane has two sides: the one where the centre starts counts.
///
/// Error of t: at most 8 eps (|S0| + |D| + r) / |N.V| for the normalised plane.
std::optional<Contact> sweep(const Moving<Sphere>& moving, const Plane& plane);

}  // namespace first_contact
