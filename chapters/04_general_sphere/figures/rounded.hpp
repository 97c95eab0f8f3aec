#pragma once
#include "first_contact/figure/scene.hpp"
#include "first_contact/geometry/environment.hpp"

/// Drawings of solids and of what becomes of them when they are moved out by a radius.

/// A convex polygon in the plane z = 0, its corners anticlockwise, moved out by r: a closed line, round at
/// the corners.
std::vector<first_contact::Point> rounded_outline(const std::vector<first_contact::Point>& corners, double r);

/// The edges at which an environment bends or ends, as far as a face at them looks at the eye.
void draw_ridges(first_contact::figure::Scene& scene, const first_contact::Environment& environment,
                 const first_contact::figure::View& view, int layer);

/// A convex solid moved out by r, translucent: its faces in blue, its cylinders in green, its balls in amber.
void draw_rounded(first_contact::figure::Scene& scene, const first_contact::Environment& solid, double r,
                  const first_contact::figure::View& view, int layer);
