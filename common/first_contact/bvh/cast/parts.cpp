#include "first_contact/bvh/cast/parts.hpp"

#include "first_contact/bvh/build/split.hpp"

namespace first_contact::bvh {

namespace {

PackedTree tree_over(const Mesh& mesh, const Space& space) {
  if (mesh.size() == 0) return {};
  const Surface surface(mesh);
  return pack(split(surface, space), surface, space);
}

/// Adds each vertex of each leaf with the leaf.
template <class Add>
void each_vertex(const PackedTree& tree, const Add& add) {
  tree.each_leaf([&](Ref ref) {
    const LeafHead& leaf = leaf_at(tree.leaves.data(), ref);
    const std::uint32_t* number = vertex_numbers(leaf);
    for (int i = 0; i < leaf.vertices; ++i) add(number[i], ref);
  });
}

}  // namespace

Parts::Parts(Mesh triangles)
    : mesh(std::move(triangles)),
      space(mesh),
      packed(tree_over(mesh, space)),
      leaves_at(mesh.vertices().size(), [&](const auto& add) { each_vertex(packed, add); }),
      walker(best_walker()) {
  const Point& center = space.center();
  tree = {packed.nodes.data(),
          packed.leaves.data(),
          packed.root,
          packed.leaf_size,
          {center.x(), center.y(), center.z()},
          space.scale(),
          1 + space.length(center.cwiseAbs().maxCoeff())};
}

}  // namespace first_contact::bvh
