#pragma once
#include "first_contact/figure/scene.hpp"

/// What several drawings of slides have in common.

inline const first_contact::figure::Pen wall_edge{first_contact::figure::colour::blue, 1.2};
inline const first_contact::figure::Pen offset_edge{first_contact::figure::colour::grey, 1.2, true};
inline const first_contact::figure::Pen way{first_contact::figure::colour::green, 2.4};
inline const first_contact::figure::Pen undone{first_contact::figure::colour::grey, 1.6, true};
inline constexpr first_contact::figure::View from_the_side{90, 0};

/// The sphere's outline where it would have been.
void add_ghost(first_contact::figure::Scene& scene, const first_contact::Sphere& ball,
               const first_contact::figure::View& view);

/// A contact shadow on the ground below.
void add_shadow(first_contact::figure::Scene& scene, const first_contact::Sphere& ball, double opacity = 1);
