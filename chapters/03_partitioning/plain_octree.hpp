#pragma once
#include <optional>

#include "first_contact/sweep/contact.hpp"
#include "plain_tree.hpp"

/// An octree, as one writes it first: right for coins, which have a place and no size.

namespace partitioning_chapter {

/// The octree of those of the places that are named by their numbers, all within the cube; it is cut at most
/// so many times.
PlainTree plain_octree(std::span<const first_contact::Point> places, const first_contact::Bounds& cube,
                       const std::vector<std::size_t>& things, int cuts);

/// The octree of the middles of triangles.
PlainTree plain_octree_of(std::span<const first_contact::Triangle> triangles);

/// How many flights lose their contact in the octree of the middles: its triangle is not found.
/// \param contacts  one a flight, or none
std::size_t plain_octree_loses(std::span<const first_contact::Triangle> triangles,
                               std::span<const first_contact::Moving<first_contact::Sphere>> flights,
                               std::span<const std::optional<first_contact::Contact>> contacts);

}  // namespace partitioning_chapter
