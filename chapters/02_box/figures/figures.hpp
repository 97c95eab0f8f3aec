#pragma once
#include "first_contact/geometry/plane.hpp"
#include "first_contact/program/program.hpp"
#include "first_contact/sweep/box_plane.hpp"

/// All figures of the chapter.
void draw_box_figures(const first_contact::program::Program& program, const first_contact::Plane& plane,
                      const first_contact::Moving<first_contact::Box>& moving,
                      const std::optional<first_contact::Contact>& contact);

/// Figure 1: a shape, its bounding box and its bounding circle.
void draw_bounding_shapes(const first_contact::figure::Studio& studio);
/// A leaning plank in its bounding sphere, its upright and its turned box, each with its volume beside the
/// plank's.
void draw_tightness(const first_contact::figure::Studio& studio);
/// Figure 4: from the lowest vertex to the highest, along three edges, the box rises |R.N| + |S.N| + |T.N|;
/// its centre is half as high.
void draw_effective_radius(const first_contact::figure::Studio& studio);
/// Figure 5: the sweep of this run. The box meets E when its centre meets E', which is E moved out by r_eff.
void draw_sweep(const first_contact::figure::Studio& studio, const first_contact::Plane& plane,
                const first_contact::Moving<first_contact::Box>& moving,
                const std::optional<first_contact::Contact>& contact);
/// One brick on a vertex, an edge and a face.
void draw_landings(const first_contact::figure::Studio& studio);
/// The paper's vertices with one common sign for the three axes, and all eight: stopped where the lowest of
/// them touches.
void draw_signs(const first_contact::program::Program& program);
/// What a camera sees: the frustum, boxes that are kept (green, or amber if out of view) and rejected (grey);
/// and the same from above.
void draw_frustum(const first_contact::figure::Studio& studio);
