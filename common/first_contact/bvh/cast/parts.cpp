#include "first_contact/bvh/cast/parts.hpp"

#include "first_contact/bvh/build/split.hpp"

namespace first_contact::bvh {

Parts::Parts(Mesh triangles) : mesh(std::move(triangles)), space(mesh), walker(best_walker()) {
  const Merged merged(mesh);
  BinaryTree binary;
  if (mesh.size() > 0) binary = split(mesh, space, merged);
  surface.emplace(mesh, merged, binary.order);
  packed = pack(binary, *surface, space);
  const Point& center = space.center();
  tree = {packed.nodes.data(),
          packed.leaves.data(),
          surface->places().data(),
          packed.root,
          packed.leaf_size,
          {center.x(), center.y(), center.z()},
          space.scale(),
          1 + space.length(center.cwiseAbs().maxCoeff())};
}

}  // namespace first_contact::bvh
