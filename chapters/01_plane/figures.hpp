#pragma once
#include "first_contact/geometry/plane.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/program/program.hpp"
#include "first_contact/sweep/contact.hpp"

/// Figures 2 and 3 of the paper, what a normal of another length does, and the sweep of this run.
void draw_plane_figures(const first_contact::program::Program& program, const first_contact::Plane& plane,
                        const first_contact::Moving<first_contact::Sphere>& ball,
                        const std::optional<first_contact::Contact>& contact);
