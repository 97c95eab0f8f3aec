#include "first_contact/bvh/bvh.hpp"

#include <string>

#include "first_contact/bvh/cast/overlap.hpp"
#include "first_contact/bvh/cast/parts.hpp"
#include "first_contact/bvh/cast/turns.hpp"
#include "first_contact/geometry/refuse.hpp"

namespace first_contact {

Bvh::Bvh(Mesh mesh) {
  constexpr std::size_t most_triangles = std::size_t{1} << 28;
  if (mesh.size() > most_triangles)
    throw std::length_error("a mesh of " + std::to_string(mesh.size()) +
                            " triangles: a fast tree must have at most 2^28");
  parts_ = std::make_unique<const bvh::Parts>(std::move(mesh));
}

Bvh::~Bvh() = default;
Bvh::Bvh(Bvh&&) noexcept = default;
Bvh& Bvh::operator=(Bvh&&) noexcept = default;

const Mesh& Bvh::mesh() const { return parts_->mesh; }

std::size_t Bvh::bytes() const {
  const bvh::Parts& p = *parts_;
  return p.packed.nodes.size() * sizeof(bvh::Node) + p.packed.leaves.size() * sizeof(bvh::LeafUnit) +
         p.leaves_at.bytes();
}

bool overlap(const Sphere& sphere, const Bvh& bvh) { return bvh::overlap(sphere, bvh.parts()); }

std::optional<Contact> sweep(const Moving<Sphere>& moving, const Bvh& bvh) {
  return sweep(moving, bvh.parts(), bvh.parts().walker);
}

void sweep(std::span<const Moving<Sphere>> moving, const Bvh& bvh, std::span<std::optional<Contact>> first) {
  if (first.size() != moving.size())
    refuse("sweep of many spheres: " + std::to_string(first.size()) + " contacts for " +
               std::to_string(moving.size()) + " spheres",
           "must be as many");
  bvh::Turns(moving, bvh.parts(), first).run();
}

}  // namespace first_contact
