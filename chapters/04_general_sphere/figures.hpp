#pragma once
#include "first_contact/geometry/environment.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/program/program.hpp"
#include "first_contact/sweep/contact.hpp"

/// Figures 6 to 9 of the paper, the moved-out solid, a ray and a triangle, the bunny, and the sweep of this
/// run.
void draw_general_sphere_figures(const first_contact::program::Program& program,
                                 const first_contact::Environment& environment,
                                 const first_contact::Moving<first_contact::Sphere>& moving,
                                 const std::optional<first_contact::Contact>& contact);
