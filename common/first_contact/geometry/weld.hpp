#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "first_contact/geometry/space.hpp"

namespace first_contact {

/// Points at the very same position are one: for each point the lowest number of a point at its position.
/// (0 and -0 are one position; points that are only near each other are two.) In O(n).
std::vector<std::uint32_t> welded(std::span<const Point> points);

}  // namespace first_contact
