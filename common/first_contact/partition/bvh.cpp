#include "first_contact/partition/bvh.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

#include "first_contact/partition/bvh/cast.hpp"
#include "first_contact/partition/bvh/parts.hpp"

namespace first_contact {

Bvh::Parts::Parts(Mesh triangles) : mesh(std::move(triangles)), space(mesh) {
  const bvh::Merged merged(mesh);
  bvh::BinaryTree binary;
  if (mesh.size() > 0) binary = bvh::split(mesh, space, merged);
  surface.emplace(mesh, merged, binary.order);
  packed = bvh::pack(binary, *surface, space);
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

Bvh::Bvh(Mesh mesh) {
  constexpr std::size_t most_triangles = std::size_t{1} << 28;
  if (mesh.size() > most_triangles) throw std::length_error("Bvh: a mesh may have 2^28 triangles at most");
  parts_ = std::make_unique<const Parts>(std::move(mesh));
}

Bvh::~Bvh() = default;
Bvh::Bvh(Bvh&&) noexcept = default;
Bvh& Bvh::operator=(Bvh&&) noexcept = default;

const Mesh& Bvh::mesh() const { return parts_->mesh; }

std::size_t Bvh::bytes() const {
  const Parts& p = *parts_;
  return p.packed.nodes.size() * sizeof(bvh::Node) + p.packed.leaves.size() + p.surface->bytes();
}

const bvh::Walker& bvh::best_walker() {
#if defined(__x86_64__)
  static const bool has_avx2 =
      avx2_walker.next && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  return has_avx2 ? avx2_walker : portable_walker;
#else
  return portable_walker;
#endif
}

std::optional<Contact> bvh::sweep(const Moving<Sphere>& moving, const Bvh& bvh, const Walker& walker) {
  Cast cast(moving, bvh.parts(), walker);
  cast.run();
  return cast.contact();
}

std::optional<Contact> sweep(const Moving<Sphere>& moving, const Bvh& bvh) {
  return bvh::sweep(moving, bvh, bvh::best_walker());
}

//! [sweep_batch]
void sweep(std::span<const Moving<Sphere>> moving, const Bvh& bvh, std::span<std::optional<Contact>> first) {
  constexpr std::size_t at_once = 12;
  struct Turn {
    std::optional<bvh::Cast> cast;
    std::size_t number = 0;
  };
  std::vector<Turn> turns(std::min(at_once, moving.size()));
  std::size_t next = 0;
  const auto begin = [&](Turn& turn) {
    turn.number = next;
    if (next < moving.size()) turn.cast.emplace(moving[next++], bvh.parts(), bvh::best_walker());
  };
  for (Turn& turn : turns) begin(turn);
  for (std::size_t done = 0; done < moving.size();)
    for (Turn& turn : turns) {
      if (!turn.cast || turn.cast->step()) continue;
      first[turn.number] = turn.cast->contact();
      ++done;
      turn.cast.reset();
      begin(turn);
    }
}
//! [sweep_batch]

}  // namespace first_contact
