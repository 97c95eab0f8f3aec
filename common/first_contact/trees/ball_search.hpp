#pragma once
#include "first_contact/geometry/unit_scale.hpp"
#include "first_contact/sweep/contact.hpp"
#include "first_contact/trees/search.hpp"

namespace first_contact {

/// How much further than it reaches a search looks, in units of the largest coordinate of the scene and the
/// motion: no object that its own test would hit may be passed over for rounding. A sweep may report a hit
/// that is 16 eps L too far away, with L below 20 such units; where a polygon was cut by the planes of a BSP
/// tree, at most 64 on the way to a leaf, each cut moves its outline by less than 16 eps, and it may reach
/// 256 eps beyond a plane. Together less than 2000 eps; this is twice as much.
/// \see tests/property/partition.cpp
inline constexpr double search_margin = 0x1p-40;  // 4096 eps

/// A moving ball among objects: which could it touch?
class BallSearch : public Search {
 public:
  /// \param scene the bounds of all objects
  BallSearch(const Moving<Sphere>& ball, const Bounds& scene);

  bool reaches(const Bounds& box) const override;
  /// The paper's same-side rejection (1.4): with E.Q > r_eff at both ends of this part of the motion it is
  /// in front of the plane, with E.Q < -r_eff at both ends behind it; or else it is split where it crosses.
  Sides sides(const Plane& plane, const Passage& part) const override;
  Vector heading() const override { return unit_scale(largest(ball_.displacement)) * ball_.displacement; }

 protected:
  /// What moves.
  const Moving<Sphere>& ball() const { return ball_; }
  /// From now on, only what is hit up to this time matters.
  void forget_after(double time) { last_ = time; }

 private:
  Moving<Sphere> ball_;
  double reach_;  // radius and margin
  double last_ = 1;
};

}  // namespace first_contact
