#pragma once
#include "first_contact/bvh/build/lists.hpp"
#include "first_contact/bvh/build/pack.hpp"
#include "first_contact/bvh/build/space.hpp"
#include "first_contact/bvh/kernels/walker.hpp"

namespace first_contact::bvh {

/// What a fast tree is made of.
struct Parts {
  explicit Parts(Mesh triangles);

  Mesh mesh;
  Space space;
  PackedTree packed;
  Lists leaves_at;  ///< of each vertex of the mesh, by the lowest number at its position

  Tree tree;             ///< all this, for the walks
  const Walker& walker;  ///< the best for the machine that runs this
};

}  // namespace first_contact::bvh
