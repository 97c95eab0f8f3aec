#pragma once
#include "first_contact/bvh/build/merged.hpp"
#include "first_contact/bvh/build/pack.hpp"
#include "first_contact/bvh/build/space.hpp"
#include "first_contact/bvh/bvh.hpp"
#include "first_contact/bvh/cast/surface.hpp"
#include "first_contact/bvh/kernels/walk.hpp"

namespace first_contact {

/// What a Bvh is made of.
struct Bvh::Parts {
  explicit Parts(Mesh triangles);

  Mesh mesh;
  bvh::Space space;
  bvh::PackedTree packed;
  std::optional<bvh::Surface> surface;

  bvh::Tree tree;             ///< all this, for the walks
  const bvh::Walker& walker;  ///< the best for the machine that runs this
};

namespace bvh {

/// The walker for the machine that runs this.
const Walker& best_walker();

/// The sweep with a given walker: for tests, which compare them.
std::optional<Contact> sweep(const Moving<Sphere>& moving, const Bvh& bvh, const Walker& walker);

}  // namespace bvh
}  // namespace first_contact
