#pragma once
#include <string>
#include <vector>

#include "first_contact/figure/scene.hpp"

/// What several drawings of solids and spheres have in common.

/// x to the right, y upwards: for pictures in the plane.
inline constexpr first_contact::figure::View from_above{0, 0};
inline const first_contact::figure::Fill solid{
    first_contact::figure::colour::floor, 1, false,
    first_contact::figure::Pen{first_contact::figure::colour::blue, 1.6}};
inline const first_contact::figure::Pen moved_out{first_contact::figure::colour::grey, 1.4, true};

/// A point of a picture in the plane.
first_contact::Point at(double x, double y);

/// Part of a circle, by the angles of its ends in degrees.
std::vector<first_contact::Point> arc(const first_contact::Point& center, double radius, double from = 0,
                                      double to = 360);

/// Writes the figure.
void finish(const first_contact::figure::Studio& studio, const std::string& name,
            const first_contact::figure::Scene& scene);
