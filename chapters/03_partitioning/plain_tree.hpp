#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "first_contact/geometry/bounds.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/geometry/triangle.hpp"
#include "first_contact/sweep/moving.hpp"

/// Trees of boxes, as one writes them first: the box of a node is cut into parts, or its list of things is,
/// and all that the ball could reach is found.

namespace partitioning_chapter {

//! [plain_tree]
/// A box with a few things, or with parts of its own kind.
struct PlainTree {
  first_contact::Bounds box;
  std::vector<std::size_t> things;  // of a leaf: their numbers
  std::vector<PlainTree> parts;     // of any other
};
//! [plain_tree]

/// A BVH of those of the things that are named by their numbers: the list is cut in half.
PlainTree plain_tree(std::span<const first_contact::Bounds> all, std::vector<std::size_t> things);

/// The numbers of all things in those leaves that the ball reaches.
std::vector<std::size_t> plain_search(const PlainTree& tree,
                                      const first_contact::Moving<first_contact::Sphere>& ball);

/// How many triangles it finds, over all flights.
std::size_t plain_tests(std::span<const first_contact::Triangle> triangles,
                        std::span<const first_contact::Moving<first_contact::Sphere>> flights);

}  // namespace partitioning_chapter
