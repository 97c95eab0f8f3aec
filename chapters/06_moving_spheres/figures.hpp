#pragma once
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/program/program.hpp"
#include "first_contact/sweep/contact.hpp"

/// Figures 11 and 12 of the paper, the closest approach of this run, and the errors of the two formulas.
void draw_moving_spheres_figures(const first_contact::program::Program& program,
                                 const first_contact::Moving<first_contact::Sphere>& p,
                                 const first_contact::Moving<first_contact::Sphere>& q);

/// The distance of the centres as time goes by.
void draw_distance(const first_contact::program::Program& program,
                   const first_contact::Moving<first_contact::Sphere>& p,
                   const first_contact::Moving<first_contact::Sphere>& q);

/// How the work for n spheres grows: every pair, one axis, and boxes halved like quicksort.
void draw_growth(const first_contact::program::Program& program);
