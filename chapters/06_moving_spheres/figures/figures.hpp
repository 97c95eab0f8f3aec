#pragma once
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/program/program.hpp"
#include "first_contact/sweep/contact.hpp"

/// All figures of the chapter.
void draw_moving_spheres_figures(const first_contact::program::Program& program,
                                 const first_contact::Moving<first_contact::Sphere>& p,
                                 const first_contact::Moving<first_contact::Sphere>& q);

/// Figure 11: two spheres, each moving along a straight line with constant velocity.
void draw_motions(const first_contact::figure::Studio& studio);
/// Figure 12: the point of contact C is on the line of the centres, r_P from P(t).
void draw_contact(const first_contact::figure::Studio& studio);
/// The distance of the centres as time goes by: below d the spheres overlap, from t1 to t2.
void draw_distance(const first_contact::program::Program& program,
                   const first_contact::Moving<first_contact::Sphere>& p,
                   const first_contact::Moving<first_contact::Sphere>& q);
/// The sweep of this run as seen from Q: P has become a point, Q has grown to the radius d, and the square
/// root is half the chord. Nothing if neither moves as seen from the other.
void draw_closest_approach(const first_contact::figure::Studio& studio,
                           const first_contact::Moving<first_contact::Sphere>& p,
                           const first_contact::Moving<first_contact::Sphere>& q);
/// Errors and losses against the distance: both formulas, in single and in double precision.
void draw_far_away(const first_contact::program::Program& program);
/// How the work for n spheres grows: every pair, one axis, and boxes halved like quicksort.
void draw_growth(const first_contact::program::Program& program);
