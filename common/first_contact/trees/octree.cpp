#include "first_contact/trees/octree.hpp"

#include <algorithm>
#include <array>

namespace first_contact {

namespace {

// Which of a cube's eight parts a point is in: bits 0, 1, 2 are set beyond the middle in x, y, z.
unsigned octant_of(const Point& point, const Point& middle) {
  unsigned octant = 0;
  for (int axis = 0; axis < 3; ++axis)
    if (point[axis] >= middle[axis]) octant |= 1U << axis;
  return octant;
}

// The lowest corner of one of the eight parts of a cube.
Point corner_of(unsigned octant, const Point& low, const Point& middle) {
  Point corner = low;
  for (int axis = 0; axis < 3; ++axis)
    if (octant >> axis & 1U) corner[axis] = middle[axis];
  return corner;
}

// The cube around the objects' centres, which are what is divided.
OctreeNode cube_around(std::span<const Bounds> objects) {
  Bounds centers;
  for (const Bounds& object : objects) centers.extend(middle_of(object));
  if (objects.empty()) return {{}, Point::Zero(), 0};
  return {bounds_of(objects), centers.min(), centers.sizes().maxCoeff()};
}

}  // namespace

Octree::Octree(std::span<const Triangle> polygons, const OctreeLimits& limits)
    : Octree(bounds_of_each(polygons), limits) {}

Octree::Octree(std::span<const Bounds> objects, const OctreeLimits& limits)
    : NodeTree(all_in_order(objects.size())) {
  nodes_.push_back(cube_around(objects));
  nodes_[0].end = static_cast<std::uint32_t>(objects.size());
  divide(0, objects, limits, 0);
}

//! [divide]
void Octree::divide(std::size_t node, std::span<const Bounds> objects, const OctreeLimits& limits,
                    std::size_t depth) {
  depth_ = std::max(depth_, depth);
  const Node parent = nodes_[node];
  const bool in_one_point = !(parent.side > 0);
  if (parent.end - parent.begin <= limits.capacity || depth >= limits.depth || in_one_point) return;

  nodes_[node].first_child = static_cast<std::uint32_t>(nodes_.size());
  distribute(parent, objects);
  for (unsigned octant = 0; octant < 8; ++octant)
    divide(nodes_[node].first_child + octant, objects, limits, depth + 1);
}
//! [divide]

// Appends the eight children of a node and hands its objects on to them.
void Octree::distribute(const Node& parent, std::span<const Bounds> objects) {
  work_ += parent.end - parent.begin;
  const double half = 0.5 * parent.side;
  const Point middle = parent.low + Vector::Constant(half);
  std::array<std::vector<std::uint32_t>, 8> octants;
  for (std::uint32_t i = parent.begin; i < parent.end; ++i)
    octants[octant_of(middle_of(objects[order_[i]]), middle)].push_back(order_[i]);
  std::uint32_t at = parent.begin;
  for (unsigned i = 0; i < 8; ++i) {
    Node child{{}, corner_of(i, parent.low, middle), half};
    child.begin = at;
    for (const std::uint32_t object : octants[i]) {
      child.bounds.extend(objects[object]);
      order_[at++] = object;
    }
    child.end = at;
    nodes_.push_back(child);
  }
}

void Octree::search(Search& search) const {
  const Vector heading = search.heading();
  const unsigned nearest = octant_of(Point::Zero(), heading);  // seen from where the motion comes
  show(0, search, nearest, 0);
}

//! [show]
void Octree::show(std::size_t node, Search& search, unsigned nearest, std::size_t depth) const {
  search.count_node(depth);
  const Node& here = nodes_[node];
  if (here.bounds.isEmpty() || !search.reaches(here.bounds)) return;
  if (here.is_leaf())
    for (std::uint32_t i = here.begin; i < here.end; ++i) search.test(order_[i]);
  else
    for (unsigned i = 0; i < 8; ++i) show(here.first_child + (i ^ nearest), search, nearest, depth + 1);
}
//! [show]

}  // namespace first_contact
