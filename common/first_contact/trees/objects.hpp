#pragma once
#include <utility>
#include <vector>

#include "first_contact/trees/collection.hpp"

namespace first_contact {

/// Many objects of any shape, known by their bounds, and the tree that finds them: `Objects<Octree>`,
/// `Objects<BruteForce>`.
template <Partition Tree>
using Objects = Collection<Bounds, Tree>;

//! [pairs]
/// All pairs of objects whose bounds overlap, the lower number first, in ascending order.
template <Partition Tree>
std::vector<std::pair<std::size_t, std::size_t>> pairs(const Objects<Tree>& objects) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (std::size_t i = 0; i < objects.all().size(); ++i)
    for (const std::size_t j : near(objects.all()[i], objects))
      if (i < j) found.emplace_back(i, j);
  return found;
}
//! [pairs]

}  // namespace first_contact
