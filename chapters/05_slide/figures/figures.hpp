#pragma once
#include <vector>

#include "first_contact/program/program.hpp"
#include "scene.hpp"
#include "walk.hpp"

/// All figures of the chapter.
void draw_slide_figures(const first_contact::program::Program& program,
                        const first_contact::Environment& environment,
                        const first_contact::Moving<first_contact::Sphere>& ball,
                        const first_contact::Slide& path);

/// Figure 10: on its way from P1 to P2 the ball meets the wall at Q; its new position is P3.
void draw_projection(const first_contact::figure::Studio& studio);
/// The same motion twice: Q as the touched point, and as the centre.
void draw_half_sunk(const first_contact::program::Program& program);
/// A ball in a room: after the first wall alone it would end beyond the second, at P3; the loop ends at P.
void draw_room(const first_contact::figure::Studio& studio, const char* name,
               const std::vector<Rectangle>& room, const first_contact::Moving<first_contact::Sphere>& ball);
/// The motions that lead into neither of two walls, and the nearest of them to one that does.
void draw_wedge(const first_contact::program::Program& program);
/// At a shallow angle a gap that is laid back along the path is next to none; along the normal it is what it
/// is.
void draw_gap(const first_contact::program::Program& program);
/// Frame after frame with the same wish, a ball slides over the bunny's back, its cheek and its chest.
void draw_bunny(const first_contact::figure::Studio& studio);
/// Pressed into a corner of 120 degrees: wall after wall the ball jitters, with both walls it stands.
void draw_jitter(const first_contact::program::Program& program);
/// The slide of this run.
void draw_run(const first_contact::figure::Studio& studio, const first_contact::Environment& environment,
              const first_contact::Moving<first_contact::Sphere>& ball, const first_contact::Slide& path);
/// A walk over the terrain, which is the first of the grounds.
void draw_walk(const first_contact::figure::Studio& studio, const walks::Ground& terrain,
               const walks::Walk& walk);
