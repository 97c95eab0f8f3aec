#pragma once
#include "first_contact/program/program.hpp"

/// What goes wrong with bounces and tweens elsewhere, and what it costs.
namespace tween_bounce {

/// Energy after a minute, restitution 1: time steps against impacts that are solved for.
void tell_energy(first_contact::program::Program& program);
/// Two mistakes of tweens: speed by a curve's parameter, and a lerp by a tenth in each frame.
void tell_tweens(first_contact::program::Program& program);

}  // namespace tween_bounce
