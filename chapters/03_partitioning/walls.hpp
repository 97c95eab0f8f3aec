#pragma once
#include <optional>
#include <vector>

#include "first_contact/sweep/contact.hpp"
#include "first_contact/trees/box_tree.hpp"
#include "first_contact/trees/bsp_tree.hpp"
#include "first_contact/trees/cast.hpp"
#include "first_contact/trees/octree.hpp"

/// \file
/// Walls seen from above, three trees of them, and a ball that rolls among them. As all walls are equally
/// high, the octree is a quadtree in the plane: of eight children the upper four are empty.

namespace partitioning_chapter {

/// Fourteen walls in a yard of 6 by 5: triangles that stand upright, half above the plane z = 0, half below.
struct Yard {
  std::vector<first_contact::Triangle> walls;
  ///@{
  /// Cut until one wall is left in each part.
  first_contact::Octree octree;
  first_contact::BspTree bsp;
  first_contact::BoxTree bvh;
  ///@}

  Yard();
  first_contact::Bounds bounds() const { return octree.node(0).bounds; }
};

/// Where a ball rolls in the plane z = 0.
struct Roll {
  Eigen::Vector2d from{5.9, 0.5}, to{0.4, 4.3};
  double radius = 0.15;

  first_contact::Moving<first_contact::Sphere> ball() const;
};

/// What a search of one tree finds, and what it took.
struct Found {
  first_contact::Statistics counted;
  std::optional<first_contact::Contact> contact;
};

/// The first wall on the ball's way, looked for in a tree of the yard.
template <class Tree>
Found found_in(const Tree& tree, first_contact::Cast& cast) {
  tree.search(cast);
  return {cast.statistics(), cast.contact()};
}

/// The part of a convex region before a plane (side = 1) or behind it (side = -1), its corners in order.
std::vector<first_contact::Point> part_of(const std::vector<first_contact::Point>& region,
                                          const first_contact::Plane& plane, double side);

}  // namespace partitioning_chapter
