#pragma once
#include <optional>

#include "first_contact/geometry/box.hpp"
#include "first_contact/geometry/mesh.hpp"
#include "first_contact/geometry/plane.hpp"
#include "first_contact/motion/rigid_tween.hpp"
#include "first_contact/sweep/interval.hpp"
#include "first_contact/sweep/turning_mesh.hpp"

/// \file
/// What moves and turns on its way collides, too: rigid bodies against a plane, a mesh and a box.

namespace first_contact {

/// First contact of a rigid body that goes where the tween takes it, within an interval of time. The body is given
/// as it stands where its pose is the origin without a turn; the interval and the time of the contact are on the
/// tween's own clock.
///
/// Each leg turns evenly about an axis that moves along a chord: conservative advancement (turning_mesh.hpp). Where
/// a chord of a curve, and at constant speed the turn, are off the true motion, the gap is as much larger, and the
/// chord is halved until that is a third of the gap. Then the easing is solved for the time, as for a sphere.
///
/// With g = turning_gap times the size of the scene (the largest coordinate of the tween's curves and of the
/// obstacle, and how far the body reaches from its origin): before the contact the body goes nowhere deeper than g
/// into anything that it does not already leave, at the contact it is at most g away, and nothing is passed over. A
/// body that stands on a plane by the vertex or the edge about which it turns is not in contact for that; with a
/// mesh or a box it is.
/// \throws std::invalid_argument if an easing overshoots out of range (contact.hpp).
std::optional<Contact> sweep(const RigidTween& tween, const Mesh& body, const Plane& obstacle,
                             const Interval& clock);
///@{
/// The same.
std::optional<Contact> sweep(const RigidTween& tween, const Mesh& body, const Mesh& obstacle,
                             const Interval& clock);
std::optional<Contact> sweep(const RigidTween& tween, const Mesh& body, const Box& obstacle,
                             const Interval& clock);
///@}

/// The same for a box, by its surface.
template <class Any>
std::optional<Contact> sweep(const RigidTween& tween, const Box& body, const Any& obstacle,
                             const Interval& clock) {
  return sweep(tween, surface_of(body), obstacle, clock);
}
/// From the first pose to the last.
template <class Body, class Any>
requires(std::same_as<Body, Box> ||
         std::same_as<Body, Mesh>) std::optional<Contact> sweep(const RigidTween& tween, const Body& body,
                                                                const Any& obstacle) {
  return sweep(tween, body, obstacle, Interval(tween.begin(), tween.end()));
}

}  // namespace first_contact
