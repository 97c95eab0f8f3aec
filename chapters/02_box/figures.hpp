#pragma once
#include "first_contact/geometry/plane.hpp"
#include "first_contact/program/program.hpp"
#include "first_contact/sweep/box_plane.hpp"

/// Figures 1 and 4 of the paper, the sweep of this run as its figure 5, and the chapter's own: three
/// landings, bounding shapes compared, a camera's frustum.
void draw_box_figures(const first_contact::program::Program& program, const first_contact::Plane& plane,
                      const first_contact::Moving<first_contact::Box>& moving,
                      const std::optional<first_contact::Contact>& contact);
