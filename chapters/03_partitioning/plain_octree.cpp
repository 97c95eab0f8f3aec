#include "plain_octree.hpp"

#include <algorithm>
#include <array>
#include <numeric>

using namespace first_contact;

namespace partitioning_chapter {

//! [plain_octree]
PlainTree plain_octree(std::span<const Point> places, const Bounds& cube,
                       const std::vector<std::size_t>& things, int cuts) {
  if (things.size() <= 1 || cuts == 0) return {cube, things, {}};  // two in one place are never parted
  PlainTree tree{cube, {}, {}};
  const Point middle = middle_of(cube);
  std::array<std::vector<std::size_t>, 8> eighths;
  for (const std::size_t thing : things) {
    unsigned bits = 0;  // one for each axis: beyond the middle?
    for (int axis = 0; axis < 3; ++axis)
      if (places[thing][axis] >= middle[axis]) bits |= 1U << axis;
    eighths[bits].push_back(thing);
  }
  for (unsigned bits = 0; bits < 8; ++bits) {
    Bounds eighth(middle);
    eighth.extend(cube.corner(static_cast<Bounds::CornerType>(bits)));
    tree.parts.push_back(plain_octree(places, eighth, eighths[bits], cuts - 1));
  }
  return tree;
}
//! [plain_octree]

PlainTree plain_octree_of(std::span<const Triangle> triangles) {
  std::vector<Point> places;
  for (const Triangle& triangle : triangles) places.push_back(middle_of(bounds_of(triangle)));
  std::vector<std::size_t> things(triangles.size());
  std::iota(things.begin(), things.end(), std::size_t{0});
  return plain_octree(places, bounds_of(std::span<const Point>(places)), things, 20);
}

std::size_t plain_octree_loses(std::span<const Triangle> triangles, std::span<const Moving<Sphere>> flights,
                               std::span<const std::optional<Contact>> contacts) {
  const PlainTree tree = plain_octree_of(triangles);
  std::size_t lost = 0;
  for (std::size_t i = 0; i < flights.size(); ++i) {
    if (!contacts[i]) continue;
    const auto found = plain_search(tree, flights[i]);
    lost += std::count(found.begin(), found.end(), contacts[i]->triangle) == 0;
  }
  return lost;
}

}  // namespace partitioning_chapter
