#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

#include "first_contact/geometry/sphere.hpp"
#include "first_contact/motion/curve.hpp"
#include "first_contact/sweep/obstacle.hpp"

/// \file
/// A sweep along a curve: between two pictures motion is taken as straight, even along a curve (paper, 1.1).
/// Here it is said how straight.

namespace first_contact {

/// The values of u in [0, 1] between which chords stay within `deviation` of the curve, at every u: a chord
/// over a step h of u is off by at most h^2 / 8 max |C''|, and C'' is no longer than its own control vectors.
/// \throws std::invalid_argument if the deviation is not finite and positive, or would need more than 10
///     million chords.
std::vector<double> chords(const Curve& curve, double deviation);

/// The first contact along a curve.
struct CurveContact {
  double u;         ///< where on the curve, in [0, 1]
  Contact contact;  ///< how; its time is that of the motion along the chord on which it happens
};

/// First contact of a sphere that moves along a curve, its centre at C(u), with any obstacle.
///
/// The sphere that is swept, along chords, is within `deviation` of the one on the curve, at every u. So if
/// nothing is hit, no true sphere of a radius smaller by `deviation` hits anything; to miss nothing, pass a
/// radius larger by it.
/// \throws std::invalid_argument as chords() does, or if the radius is negative or not finite.
template <Obstacle Any>
std::optional<CurveContact> sweep_along(const Curve& curve, double radius, const Any& obstacle,
                                        double deviation) {
  const std::vector<double> u = chords(curve, deviation);
  Point from = at(curve, u.front());
  for (std::size_t i = 1; i < u.size(); ++i) {
    const Point to = at(curve, u[i]);
    const auto contact = sweep(Moving<Sphere>{{from, radius}, to - from}, obstacle);
    if (contact) return CurveContact{lerp(u[i - 1], u[i], contact->time), *contact};
    from = to;
  }
  return std::nullopt;
}

}  // namespace first_contact
