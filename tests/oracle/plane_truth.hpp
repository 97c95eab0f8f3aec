#pragma once
#include <array>
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "first_contact/sweep/contact.hpp"
#include "first_contact/sweep/plane_error.hpp"

/// \file
/// What is true of shapes that move towards a plane, in 50 digits, by formulas of its own: a box is its eight
/// vertices and a sphere the point of it that is nearest.

namespace oracle {

using Exact = boost::multiprecision::cpp_dec_float_50;
using ExactVector = std::array<Exact, 3>;
using first_contact::Point;
using first_contact::Vector;

inline ExactVector exact(const Vector& v) { return {Exact(v.x()), Exact(v.y()), Exact(v.z())}; }
inline Exact dot(const ExactVector& a, const ExactVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The plane as its user gives it, before any division.
struct GivenPlane {
  Vector normal;
  double offset;
};

/// What a plane is to a moving shape: how far it is, on the side of the centre, and how fast the shape comes.
struct Truth {
  Exact gap;       ///< from the plane to the nearest point of the shape; negative if they overlap
  Exact approach;  ///< N.V with N towards the shape; negative if it comes nearer
  Exact time() const { return gap > 0 ? Exact(-gap / approach) : Exact(0); }
  bool hit() const { return approach < 0 && time() <= 1; }
};

/// The truth for a body that is the hull of `corners`, blown up by `radius`.
template <class Corners>
Truth truth(const Point& center, const Corners& corners, double radius, const Vector& v,
            const GivenPlane& plane) {
  const ExactVector n = exact(plane.normal);
  const Exact length = sqrt(dot(n, n));
  const auto distance = [&](const ExactVector& p) {
    return Exact((dot(n, p) + Exact(plane.offset)) / length);
  };
  const Exact side = distance(exact(center)) < 0 ? -1 : 1;
  Exact nearest = std::numeric_limits<double>::max();
  for (const ExactVector& corner : corners) {
    const Exact d = side * distance(corner);
    if (d < nearest) nearest = d;
  }
  return {nearest - Exact(radius), side * dot(n, exact(v)) / length};
}

/// The error of an answer, in units of the bound that the library and the notes state, `error_of_time`, where
/// `lengths` are those of the scene. An answer that differs in kind is held to the same bound:
/// the motion must then end, to within it, where the contact begins.
inline double error_in_bounds(const Truth& truth, const std::optional<first_contact::Contact>& contact,
                              double lengths, double speed) {
  const double epsilon = std::numeric_limits<double>::epsilon();
  if (!contact && !truth.hit()) return 0;
  if (!contact && truth.approach >= -Exact(2 * epsilon * speed)) return 0;  // parallel, to within rounding
  if (contact && truth.approach >= 0) return truth.approach <= Exact(2 * epsilon * speed) ? 0 : 1e300;
  const Exact answer = contact ? Exact(contact->time) : Exact(1);
  const Exact bound = first_contact::error_of_time<Exact>(lengths, answer * speed, truth.approach);
  return static_cast<double>(Exact(abs(answer - truth.time()) / bound));
}

/// Random scenes: any, and aimed at what is hard.
class Scenes {
 public:
  explicit Scenes(unsigned seed) : engine_(seed) {}
  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  Vector vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
  /// A length of any order of magnitude between 2^-power and 2^power.
  double length(double power) { return std::exp2(number(-power, power)); }

  /// A motion from `center` that would bring a body of that radius into touch at t, with a share `slant` of
  /// it along the plane: 0 is straight on, 1e8 almost parallel.
  Vector motion_to(const GivenPlane& plane, const Point& center, double radius, double t, double slant) {
    const Vector n = plane.normal.normalized();
    const double distance = n.dot(center) + plane.offset / plane.normal.norm();
    const double gap = std::abs(distance) - radius;
    const Vector aside = n.unitOrthogonal();
    return -std::copysign(gap / t, distance) * n + slant * std::abs(gap) * (aside + n.cross(aside));
  }

 private:
  std::mt19937 engine_;
};

}  // namespace oracle
