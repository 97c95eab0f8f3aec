#pragma once
#include "first_contact/geometry/plane.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/program/program.hpp"
#include "first_contact/sweep/contact.hpp"

/// All figures of the chapter.
void draw_plane_figures(const first_contact::program::Program& program, const first_contact::Plane& plane,
                        const first_contact::Moving<first_contact::Sphere>& ball,
                        const std::optional<first_contact::Contact>& contact);

/// Figure 2: a plane E is all points Q with (Q - P) at right angles to N.
void draw_definition(const first_contact::figure::Studio& studio);
/// Figure 3: the sphere touches E exactly when its centre lies on E', which is E moved out by r.
void draw_touch(const first_contact::figure::Studio& studio);
/// What becomes of E.S = r when N has not unit length: the ball stops at the height r / |N|.
void draw_unit_normal(const first_contact::program::Program& program);
/// The sweep of this run: start, contact or end, and the plane that the centre meets.
void draw_sweep(const first_contact::figure::Studio& studio, const first_contact::Plane& plane,
                const first_contact::Moving<first_contact::Sphere>& ball,
                const std::optional<first_contact::Contact>& contact);
