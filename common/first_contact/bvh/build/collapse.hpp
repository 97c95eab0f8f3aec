#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "first_contact/bvh/build/layout.hpp"
#include "first_contact/bvh/build/split.hpp"

namespace first_contact::bvh {

/// Up to eight branches that together hold all of another branch.
struct Cover {
  std::array<std::uint32_t, width> branch;
  int count = 0;
};

/// Chooses which branches of the binary tree become nodes of the wide one, and which are skipped.
///
/// The idea: let cost(b, k) be the least expected work below branch b if it may be covered by at most k
/// children of a wide node. One child: a wide node, whose own children cover both halves with 8 in all; more:
/// the halves share the k. Filled from the leaves up, that table holds the best of all trees (dynamic
/// programming; after Ylitie, Karras, Laine 2017). It equals opening the largest child again and again, which
/// is not always the best.
class Collapse {
 public:
  explicit Collapse(const std::vector<Branch>& tree);

  /// The children of a branch that becomes a wide node.
  Cover children(std::uint32_t branch) const;

 private:
  using Costs = std::array<float, width>;  // [k - 1]: covered by at most k children

  void cover(std::uint32_t branch, std::size_t k, Cover& result) const;
  void cover_halves(std::uint32_t branch, std::size_t k, Cover& result) const;

  const std::vector<Branch>& branches_;
  std::vector<Costs> cost_;
};

}  // namespace first_contact::bvh
