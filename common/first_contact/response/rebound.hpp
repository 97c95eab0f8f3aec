#pragma once
#include "first_contact/geometry/space.hpp"

namespace first_contact {

/// How a surface at rest sends away what meets it.
struct Surface {
  /// \throws std::invalid_argument if the restitution is not in 0 .. 1, or the friction negative or not finite.
  Surface(double restitution, double friction);

  double restitution;  ///< e: the part of the speed against the surface with which it leaves
  double friction;     ///< mu: the force along the surface is at most mu times that against it (Coulomb)
};

/// What an impact makes of a motion, as a linear map of it: against the surface it is turned round and multiplied by
/// e; along it what is left is the part 1 - mu (1 + e) v_n / v_t, or none. A body without spin, or a ball whose spin
/// is not looked at.
/// \param motion  the velocity, or any displacement in its direction: lengths do not matter
/// \param normal  unit, away from the surface
/// \throws std::invalid_argument if the motion is not finite.
Eigen::Matrix3d rebound(const Vector& motion, const Vector& normal, const Surface& surface);

}  // namespace first_contact
