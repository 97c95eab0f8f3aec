#include "first_contact/bvh/bvh.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "first_contact/bvh/cast/cast.hpp"
#include "first_contact/bvh/cast/parts.hpp"

namespace first_contact {

Bvh::Parts::Parts(Mesh triangles) : mesh(std::move(triangles)), space(mesh), walker(bvh::best_walker()) {
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
  if (mesh.size() > most_triangles)
    throw std::length_error("a mesh of " + std::to_string(mesh.size()) +
                            " triangles: a fast tree must have at most 2^28");
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
  const bool has_avx2 = avx2_walker.next && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  return has_avx2 ? avx2_walker : portable_walker;
#else
  return portable_walker;
#endif
}

std::optional<Contact> sweep(const Moving<Sphere>& moving, const Bvh& bvh) {
  return bvh::sweep(moving, bvh, bvh.parts().walker);
}

namespace {

//! [sweep_batch]
/// Casts in turns. All that have come to the same stage make one step each, stage after stage: while memory
/// is on its way to one, others go on, and a processor guesses well what it has just done.
class Turns {
 public:
  Turns(std::span<const Moving<Sphere>> moving, const Bvh::Parts& parts,
        std::span<std::optional<Contact>> first)
      : moving_(moving), parts_(parts), first_(first) {}

  void run() {
    for (Turn& turn : turns_) begin(turn);
    while (under_way_ > 0) {
      each(bvh::Stage::end, [&](Turn& turn) { finish(turn); });
      each(bvh::Stage::node, [&](Turn& turn) { add(turn, turn.cast->visit_node()); });
      each(bvh::Stage::leaf, [&](Turn& turn) { add(turn, turn.cast->visit_leaf()); });
      each(bvh::Stage::corners, [&](Turn& turn) { add(turn, turn.cast->decide()); });
      each(bvh::Stage::survivors, [&](Turn& turn) { add(turn, turn.cast->fetch_corners()); });
    }
  }

 private:
  static constexpr std::size_t at_once = 12;

  struct Turn {
    std::optional<bvh::Cast> cast;
    std::size_t number;
  };
  struct Line {
    std::array<Turn*, at_once> turns;
    std::size_t length = 0;
  };

  void add(Turn& turn, bvh::Stage stage) {
    Line& line = lines_[static_cast<std::size_t>(stage)];
    line.turns[line.length++] = &turn;
  }
  template <class Step>
  void each(bvh::Stage stage, const Step& step) {
    Line& line = lines_[static_cast<std::size_t>(stage)];
    const Line now = line;
    line.length = 0;
    for (std::size_t i = 0; i < now.length; ++i) step(*now.turns[i]);
  }

  void begin(Turn& turn) {
    if (next_ == moving_.size()) return;
    turn.number = next_++;
    turn.cast.emplace(moving_[turn.number], parts_, parts_.walker);
    ++under_way_;
    add(turn, turn.cast->begin());
  }
  void finish(Turn& turn) {
    if (!turn.cast->finish()) return add(turn, turn.cast->begin());
    first_[turn.number] = turn.cast->contact();
    --under_way_;
    begin(turn);
  }

  std::span<const Moving<Sphere>> moving_;
  const Bvh::Parts& parts_;
  std::span<std::optional<Contact>> first_;
  std::array<Turn, at_once> turns_;
  std::array<Line, 5> lines_;  // one a stage
  std::size_t next_ = 0, under_way_ = 0;
};
//! [sweep_batch]

}  // namespace

void sweep(std::span<const Moving<Sphere>> moving, const Bvh& bvh, std::span<std::optional<Contact>> first) {
  if (first.size() != moving.size())
    throw std::invalid_argument("sweep of many spheres: " + std::to_string(first.size()) + " contacts for " +
                                std::to_string(moving.size()) + " spheres: must be as many");
  Turns(moving, bvh.parts(), first).run();
}

}  // namespace first_contact
