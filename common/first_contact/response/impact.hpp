#pragma once
#include <type_traits>

#include "first_contact/geometry/space.hpp"

namespace first_contact {

/// A vector in the plane (2) or in space (3).
template <int Dimension>
using VectorOf = std::conditional_t<Dimension == 2, Vector2, Vector>;

/// A body that can be struck: its mass and its velocity, in the plane (Dimension 2) or in space (3).
template <int Dimension>
struct Body {
  /// In the unit of the caller's choice.
  using Velocity = VectorOf<Dimension>;

  /// \param m  positive; infinite for what nothing can move, such as a wall.
  /// \throws std::invalid_argument if the mass is zero, negative or not a number, or the velocity is not
  /// finite.
  Body(double m, const Velocity& v);

  /// Positive, or infinite.
  double mass;
  /// Before the impact.
  Velocity velocity;
};

/// The velocities after an impact, and the impulse that p received (q received its opposite).
template <int Dimension>
struct Impact {
  ///@{
  /// After the impact; the impulse in units of mass times velocity.
  VectorOf<Dimension> velocity_p, velocity_q, impulse;
  ///@}
};

/// Impact of two smooth bodies (without friction or spin; paper, 2.4.2): the impulse along the normal that
/// turns the speed of approach s into the speed of separation e s. What is across the normal stays as it is.
/// Momentum is kept; the energy 1/2 (1 - e^2) s^2 / (1/m_p + 1/m_q) is lost. Bodies that do not approach are
/// left alone.
/// \param normal from q to p, *at contact*; of any length but zero.
/// \param restitution e in [0, 1]: 0, and they stay together; 1, and no energy is lost.
///
/// Error: a few eps of the speed of approach, whatever the units: masses, velocities and the normal may be as
/// small or as large as a double can be.
/// \throws std::invalid_argument for a zero normal, a restitution out of range, two immovable bodies that
///     approach, or a velocity or an impulse that comes out larger than any double.
template <int Dimension>
Impact<Dimension> impact(const Body<Dimension>& p, const Body<Dimension>& q,
                         const VectorOf<Dimension>& normal, double restitution);

}  // namespace first_contact
