#pragma once
#include "film/showing.hpp"
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

/// How curves are made: de Casteljau's steps, knots, ways through keys, and the bound of a chord.
void draw_curve_lessons(const first_contact::program::Program& program);
/// Why poses are not tweened by their numbers, and what is done instead.
void draw_turns(const first_contact::program::Program& program);

/// Until when a film is drawn, and in how many pictures a second.
struct FilmCut {
  double until;
  double per_second;
};
/// One picture of a film up to a time, with the images that the body leaves of itself.
void draw_still(const first_contact::program::Program& program, const Film& film, const Showing& showing,
                double until);
/// That picture, and one that moves.
void draw_film(const first_contact::program::Program& program, const Film& film, const Showing& showing,
               const FilmCut& cut);

}  // namespace tween_bounce
