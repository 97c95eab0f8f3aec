#pragma once
#include <optional>

#include "first_contact/bvh/build/merged.hpp"
#include "first_contact/bvh/build/pack.hpp"
#include "first_contact/bvh/build/space.hpp"
#include "first_contact/bvh/build/surface.hpp"
#include "first_contact/bvh/kernels/walker.hpp"

namespace first_contact::bvh {

/// What a fast tree is made of.
struct Parts {
  explicit Parts(Mesh triangles);

  Mesh mesh;
  Space space;
  PackedTree packed;
  std::optional<Surface> surface;

  Tree tree;             ///< all this, for the walks
  const Walker& walker;  ///< the best for the machine that runs this
};

}  // namespace first_contact::bvh
