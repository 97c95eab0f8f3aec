#pragma once
#include "workbook/vectors.hpp"

// 3b: which pairs of things does an octree find? The task is in task.md.
using namespace workbook;

/// A node of an octree, of which tree[0] is the root. A leaf has no children; the numbers of all things that
/// reach into its
/// cell are listed in it, so that a thing stands in several leaves.
struct Node {
  std::vector<int> children;  ///< their places in the tree
  std::vector<int> things;    ///< of a leaf
};

/// Do two boxes overlap? Boxes that only touch do.
inline bool overlap(const Bounds& a, const Bounds& b) {
  return a.least.x <= b.most.x && b.least.x <= a.most.x && a.least.y <= b.most.y && b.least.y <= a.most.y &&
         a.least.z <= b.most.z && b.least.z <= a.most.z;
}

using Signature = std::vector<std::pair<int, int>>(const std::vector<Node>& tree,
                                                   const std::vector<Bounds>& things);
#define EXERCISE_FUNCTION overlapping_pairs
