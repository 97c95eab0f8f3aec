#include "first_contact/bvh/build/collapse.hpp"

#include <algorithm>
#include <limits>

namespace first_contact::bvh {

namespace {

/// What a leaf takes to test, in node tests.
constexpr float leaf_work = 1.5F;

float surface(const Branch& branch) {
  const Floats4 d = branch.high - branch.low;
  return d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
}

}  // namespace

//! [collapse]
Collapse::Collapse(const std::vector<Branch>& tree) : branches_(tree), cost_(tree.size()) {
  for (std::size_t b = tree.size(); b-- > 0;) {  // children come after their parent
    if (tree[b].leaf()) {
      cost_[b].fill(leaf_work * surface(tree[b]));
      continue;
    }
    const Costs &left = cost_[tree[b].children], &right = cost_[tree[b].children + 1];
    Costs shared;  // [k - 1]: left and right share k
    shared.fill(std::numeric_limits<float>::infinity());
    for (std::size_t k = 2; k <= width; ++k)
      for (std::size_t j = 1; j < k; ++j)
        shared[k - 1] = std::min(shared[k - 1], left[j - 1] + right[k - j - 1]);
    cost_[b][0] = surface(tree[b]) + shared[width - 1];
    for (std::size_t k = 2; k <= width; ++k) cost_[b][k - 1] = std::min(cost_[b][k - 2], shared[k - 1]);
  }
}
//! [collapse]

Cover Collapse::children(std::uint32_t branch) const {
  Cover result;
  cover_halves(branch, width, result);
  return result;
}

void Collapse::cover(std::uint32_t branch, std::size_t k, Cover& result) const {
  const Costs& cost = cost_[branch];
  while (k > 1 && cost[k - 2] <= cost[k - 1]) --k;
  if (k == 1 || branches_[branch].leaf())
    result.branch[static_cast<std::size_t>(result.count++)] = branch;
  else
    cover_halves(branch, k, result);
}

void Collapse::cover_halves(std::uint32_t branch, std::size_t k, Cover& result) const {
  const std::uint32_t left = branches_[branch].children;
  const auto cost = [&](std::size_t j) { return cost_[left][j - 1] + cost_[left + 1][k - j - 1]; };
  std::size_t best = 1;
  for (std::size_t j = 2; j < k; ++j)
    if (cost(j) < cost(best)) best = j;
  cover(left, best, result);
  cover(left + 1, k - best, result);
}

}  // namespace first_contact::bvh
