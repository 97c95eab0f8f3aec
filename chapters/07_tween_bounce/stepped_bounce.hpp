#pragma once
#include <cstddef>
#include <vector>

namespace first_contact {

/// How a simulation goes on from one picture to the next, when it does not solve for the impact.
enum class Stepper {
  explicit_euler,       ///< height with the old speed, then the speed: gains energy
  semi_implicit_euler,  ///< the speed, then height with the new one: the energy wavers but does not run away
  parabola              ///< the exact parabola over the step: only the late impact is wrong
};

/// Height and speed at a time of a stepped simulation.
struct Stepped {
  /// Since the start.
  double time;
  /// Above the floor.
  double height;
  /// Upwards.
  double speed_up;

  /// Of a unit of mass.
  double energy(double gravity) const { return gravity * height + speed_up * speed_up / 2; }
};

/// A ball dropped from a height, in steps of dt; a ball found below the floor is put back on it and its speed
/// turned up: what most games do, and why their balls creep or fly. Compare Bounce, which drifts by nothing.
/// \throws std::invalid_argument if height or gravity is negative, dt is not positive, restitution is not in
///     [0, 1], or a value is not finite.
std::vector<Stepped> stepped_bounce(Stepper stepper, double height, double gravity, double restitution,
                                    double dt, std::size_t steps);

}  // namespace first_contact
