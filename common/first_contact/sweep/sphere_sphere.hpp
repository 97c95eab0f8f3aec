#pragma once
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/sweep/contact_times.hpp"
#include "first_contact/sweep/interval.hpp"
#include "first_contact/sweep/obstacle.hpp"

namespace first_contact {

/// Do the two spheres share a point? |P - Q| <= r_P + r_Q, with both sides squared. Touching counts.
bool overlap(const Sphere& p, const Sphere& q);

/// When two moving spheres begin to touch and when they part again: both roots of |w + t u| = d, with w = P1
/// - Q1, u = V_P - V_Q and d = r_P + r_Q (paper, 2.3). Any times, also before 0. Nothing if they never touch,
/// or if their velocities are equal, for then their distance never changes.
///
/// Error of each time: at most 8 eps (|w| + d^2 / h) / |u|, where h^2 = d^2 - |w x u|^2 / u^2; h is half the
/// way that P goes inside a sphere of radius d about Q. Spheres that come nearer than d (1 - 8 eps) are
/// always found to touch, and those that stay beyond d (1 + 8 eps) never, however far away they start.
std::optional<ContactTimes<double>> contact_interval(const Moving<Sphere>& p, const Moving<Sphere>& q);

/// First contact of a moving sphere p with a moving sphere q, the obstacle (paper, 2.3), within an interval
/// of time, t_m .. t_n; without one, in 0 .. 1. The contract is kept relative to its first time: spheres that
/// overlap at t_m have a contact at t_m if they go deeper, none if they leave. Concentric spheres have no
/// normal of their own: it is against the relative motion.
///
/// The normal points from q to p; the paper's N is its opposite. The point is the paper's C = P(t) - r_P
/// normal. Error of t: as that of contact_interval, with w at t_m, and half a unit in the last place of t.
std::optional<Contact> sweep(const Moving<Sphere>& p, const Moving<Sphere>& q, const Interval& when = {0, 1});

/// First contact of a moving sphere with one at rest.
std::optional<Contact> sweep(const Moving<Sphere>& p, const Sphere& q);

}  // namespace first_contact
