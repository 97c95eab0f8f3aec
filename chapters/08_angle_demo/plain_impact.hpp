#pragma once
#include <utility>

#include "first_contact/response/impact.hpp"

/// An impact, as one writes it first: right for a normal of length 1, and for masses that are neither huge
/// nor tiny.

namespace angle_demo_chapter {

/// The velocities of p and q after it. The unit normal points to p.
std::pair<first_contact::Vector, first_contact::Vector> plain_impact(const first_contact::Body<3>& p,
                                                                     const first_contact::Body<3>& q,
                                                                     const first_contact::Vector& normal,
                                                                     double e);

}  // namespace angle_demo_chapter
