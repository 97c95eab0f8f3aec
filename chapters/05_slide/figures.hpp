#pragma once
#include "first_contact/program/program.hpp"
#include "scene.hpp"
#include "walk.hpp"

/// Draws all figures of the chapter: the paper's figure 10, what goes wrong, and the slide of this run.
void draw_slide_figures(const first_contact::program::Program& program,
                        const first_contact::Environment& environment,
                        const first_contact::Moving<first_contact::Sphere>& ball,
                        const first_contact::Slide& path);

/// Draws a walk over the terrain, which is the first of the grounds.
void draw_walk(const first_contact::figure::Studio& studio, const walks::Ground& terrain,
               const walks::Walk& walk);
