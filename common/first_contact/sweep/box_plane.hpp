#pragma once
#include "first_contact/geometry/box.hpp"
#include "first_contact/geometry/plane.hpp"
#include "first_contact/sweep/obstacle.hpp"

namespace first_contact {

/// Do the box and the plane share a point? |E.Q| <= r_eff (paper, 1.3). Touching counts.
bool overlap(const Box& box, const Plane& plane);

/// First contact of a moving box with a plane (paper, 1.3): to this plane the box is a ball of radius r_eff,
/// whose centre meets E' = [N, D - r_eff] at t = -(E'.Q0) / (N.V). The plane has two sides: the one where the
/// centre starts counts.
///
/// The feature is what of the *box* touches: a vertex (1 point), an edge (2) or a face (4, in order around
/// it). A flat box is a rectangle, a rod or a point, and lands on what it has: on a corner of the rectangle,
/// not on an edge of no length. The points are those vertices at the time of contact, put on the plane at
/// right angles: that removes nothing but rounding if the box was apart, and the depth of the vertices if it
/// overlapped.
///
/// Error of t: at most 8 eps (|Q0| + |D| + 1/2 (|R| + |S| + |T|) + t |V|) / |N.V|.
///
/// \see tests/oracle/box_plane.cpp
std::optional<Contact> sweep(const Moving<Box>& moving, const Plane& plane);

/// The vertices of the box that reach farthest against a unit vector: 1, 2 or 4, one a column (paper, 1.3).
ContactPoints lowest_vertices(const Box& box, const Vector& normal);

/// The largest |T.N| / |T| at which an axis still counts as parallel to a plane. Turn a box and a plane by
/// one and the same rotation, and an axis that was parallel is so no longer: nine numbers of a rotation
/// matrix, each off by up to 2 eps, turn a vector by up to 6 eps, and the product with them adds sqrt(3) 3/2
/// eps. Both T and N suffer that, N is divided by its length (1), T as well (3/2), and T.N has an error of
/// its own (3/2): 22 eps at the most, and the next power of two is taken. So a box that was laid flat is
/// never found standing on a corner, and the ends of an axis that counts as parallel are level to within
/// rounding.
///
/// \see tests/unit/box_plane.cpp
inline constexpr double parallel_tolerance = 32 * std::numeric_limits<double>::epsilon();

}  // namespace first_contact
