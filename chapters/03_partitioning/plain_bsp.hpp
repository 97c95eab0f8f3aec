#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "first_contact/geometry/plane.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/geometry/triangle.hpp"
#include "first_contact/sweep/moving.hpp"

/// A BSP tree, as one writes it first: the first wall's plane cuts, and what is on both sides
/// is kept on both.

namespace partitioning_chapter {

//! [plain_node]
/// A wall, with all that is in front of its plane and all that is behind.
struct PlainBsp {
  std::optional<first_contact::Plane> plane;  // none: nothing is left
  std::size_t wall = 0;                       // its number
  std::vector<PlainBsp> sides;                // the one in front, the one behind
};
//! [plain_node]

/// The tree of those of the walls that are named by their numbers. Each has an area.
PlainBsp plain_bsp(std::span<const first_contact::Triangle> all, const std::vector<std::size_t>& walls);

/// The numbers of all walls that it does not reject; one that is on both sides of a plane may be there twice.
std::vector<std::size_t> plain_search(const PlainBsp& tree,
                                      const first_contact::Moving<first_contact::Sphere>& ball);

/// What it takes: its walls, each as often as it is kept, how deep the deepest lies, and what it finds, over
/// all flights.
struct PlainBspCost {
  std::size_t kept, depth, found;
};
PlainBspCost plain_bsp_costs(std::span<const first_contact::Triangle> walls,
                             std::span<const first_contact::Moving<first_contact::Sphere>> flights);

}  // namespace partitioning_chapter
