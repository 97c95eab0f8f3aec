#pragma once
#include <initializer_list>

#include "first_contact/sweep/turning_mesh.hpp"

/// \file
/// How the points of a turning body go on, as seen along a direction: by a height, a rate, and a bound of what the
/// turn bends.

namespace first_contact {

/// After a time t more its height is at least height + rate t - bend t^2 / 2.
struct Course {
  double height;  ///< above a point of the obstacle
  double rate;    ///< at which the height grows, in a unit of time
  double bend;    ///< at most, in a unit of time squared; not negative
};

/// How long a point surely stays above a level below its height; infinitely long if nothing brings it there.
double time_above(double level, const Course& course);

/// A turning body at a moment.
class Going {
 public:
  /// \param now  in [0, 1]
  Going(const Turning<Mesh>& turning, double now);

  /// Of the point of the body that is there now.
  Vector velocity(const Point& p) const { return displacement_ + angle_ * axis_.cross(p - hinge_); }
  /// The largest of these velocities' bounds: how fast the points may become.
  double speed_of(std::initializer_list<Point> points) const;
  /// How it goes on, as seen along a unit normal from a base.
  Course of(const Point& p, const Vector& normal, const Point& base) const;

 private:
  Point hinge_;
  Vector axis_;
  double angle_;
  Vector displacement_;
};

}  // namespace first_contact
