#pragma once
#include "first_contact/program/program.hpp"
#include "flight.hpp"

/// All figures of the chapter.
void draw_tween_bounce_figures(const first_contact::program::Program& program,
                               const tween_bounce::Flight& flight, const tween_bounce::Flight& printed,
                               const tween_bounce::Flight& physical);

namespace tween_bounce {

/// Figures 13, 14 and 15 for a flight, each also as an animation.
void draw_paper_figures(const first_contact::program::Program& program, const Flight& flight);
/// Printed against physical bounce, and what becomes of energy.
void draw_bounces(const first_contact::program::Program& program, const Flight& printed,
                  const Flight& physical);
/// Easings, curves, and spacing along them.
void draw_tweens(const first_contact::program::Program& program);

}  // namespace tween_bounce
