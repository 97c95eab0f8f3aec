#include "first_contact/bvh/cast/overlap.hpp"

#include <algorithm>
#include <array>

#include "first_contact/sweep/sphere_triangle.hpp"

namespace first_contact::bvh {

namespace {

/// May a ball at the start of the path touch what is in the child's box?
bool reaches(const Path& path, const Node& node, int child) {
  double squares = 0;
  for (int i = 0; i < 3; ++i) {
    const double origin = node.origin[i], step = node.step[i];
    const double low = origin + step * node.side[i][child], high = origin + step * node.side[3 + i][child];
    const double beyond = std::max({low - path.start[i], path.start[i] - high, 0.0});
    squares += beyond * beyond;
  }
  return squares <= double{path.reach} * path.reach;
}

bool in_leaf(const Sphere& sphere, const Mesh& mesh, const LeafHead& leaf) {
  for (int j = 0; j < leaf.triangles; ++j)
    if (first_contact::overlap(sphere, mesh.triangle(face_of(leaf, j).number))) return true;
  return false;
}

}  // namespace

bool overlap(const Sphere& sphere, const Parts& parts) {
  const Vector at_rest = Vector::Zero();
  Path path;
  if (parts.mesh.size() == 0 ||
      !find_path(parts.tree, {sphere.center.data(), at_rest.data(), sphere.radius}, path))
    return false;
  std::array<Ref, most_waiting> waiting;
  std::size_t count = 0;
  waiting[count++] = parts.tree.root;
  while (count > 0) {
    const Ref next = waiting[--count];
    if (next & leaf_bit) {
      if (in_leaf(sphere, parts.mesh, leaf_at(parts.tree.leaves, next))) return true;
      continue;
    }
    const Node& node = parts.tree.nodes[next];
    for (int j = 0; j < static_cast<int>(node.count); ++j)
      if (reaches(path, node, j)) waiting[count++] = child(node, j);
  }
  return false;
}

}  // namespace first_contact::bvh
