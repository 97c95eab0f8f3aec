#pragma once
#include "first_contact/figure/scene.hpp"

/// How the plane E and its offset E' are drawn.
inline const first_contact::figure::Pen plane_edge{first_contact::figure::colour::blue, 1.2};
inline const first_contact::figure::Pen offset_edge{first_contact::figure::colour::grey, 1.2, true};
