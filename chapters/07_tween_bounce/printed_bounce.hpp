#pragma once
#include <cstddef>
#include <vector>

#include "first_contact/motion/bounce.hpp"

namespace first_contact {

/// The fall and rebound of the paper's programs 1 to 3, as printed: the same floating-point operations in the
/// same order, so that every height agrees to the last bit with what a MATLAB interpreter computes.
///
/// Each step lowers the ball by dy = v0 dt - g t dT. The paper's v0 is the speed *downwards*; gravity's sign
/// is reversed in the fall (dT = dt at first: it brakes), t counts from the start and not from the bounce,
/// and the rebound is bent down by a dT of the other sign. For the physical motion see Bounce.
struct PrintedBounce {
  double v0 = 50;    ///< the paper's vo: speed downwards
  double y0 = 25;    ///< height at the start; the floor is 0
  double g = 9.82;   ///< gravity
  double dt = 0.01;  ///< from one sample to the next
  /// How many, with the one at the start.
  std::size_t samples = 2000;
  double restitution = 0.5;  ///< vo is multiplied by minus this at a hit; 1/2 in the paper
};

/// A sample that went below the floor and was put back on it.
struct PrintedHit {
  std::size_t sample;  ///< its number as the paper counts, from 1
  /// Since the start.
  double time;
  double speed;  ///< downwards, of the step that went below: dy / dt
};

/// What the programs compute: t and y, sample by sample, and all hits.
struct PrintedMotion {
  ///@{
  /// Times and heights.
  std::vector<double> t, y;
  ///@}
  /// In order.
  std::vector<PrintedHit> hits;
};

/// Runs the loop of the programs.
/// \throws std::invalid_argument if a value is not finite, dt is not positive, y0, g or restitution is
///     negative, there is no sample, or a height overflows.
PrintedMotion run(const PrintedBounce& bounce);

/// The tops of the arcs: the samples that are higher than the one before and not lower than the next.
std::vector<Apex> apexes(const PrintedMotion& motion);

/// The time of the first sample from which on all lie on the floor; nothing if the last one does not.
std::optional<double> rest_time(const PrintedMotion& motion);

}  // namespace first_contact
