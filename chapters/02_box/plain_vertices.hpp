#pragma once
#include <vector>

#include "first_contact/geometry/box.hpp"

/// The lowest vertices of a box, as one writes it first: right while an axis is level exactly or not at all.

namespace box_chapter {

/// The vertices that are lowest along the normal, in no particular order.
std::vector<first_contact::Point> plain_vertices(const first_contact::Box& box,
                                                 const first_contact::Vector& normal);

}  // namespace box_chapter
