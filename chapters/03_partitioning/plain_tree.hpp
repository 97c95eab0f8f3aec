#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "first_contact/geometry/bounds.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/geometry/triangle.hpp"
#include "first_contact/sweep/moving.hpp"

/// A tree of boxes, as one writes it first: the list is cut in half, and all that the ball could reach is found.

namespace partitioning_chapter {

//! [plain_tree]
/// A box about some things: a few, or two halves of many.
struct PlainTree {
  first_contact::Bounds box;
  std::vector<std::size_t> things;  // of a leaf: their numbers
  std::vector<PlainTree> halves;    // of any other
};
//! [plain_tree]

/// The tree of those of the things that are named by their numbers.
PlainTree plain_tree(std::span<const first_contact::Bounds> all, std::vector<std::size_t> things);

/// The numbers of all things in those leaves that the ball reaches.
std::vector<std::size_t> plain_search(const PlainTree& tree,
                                      const first_contact::Moving<first_contact::Sphere>& ball);

/// How many triangles it finds, over all flights.
std::size_t plain_tests(std::span<const first_contact::Triangle> triangles,
                        std::span<const first_contact::Moving<first_contact::Sphere>> flights);

}  // namespace partitioning_chapter
