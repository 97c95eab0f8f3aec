#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <span>

#include "first_contact/geometry/mesh.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/sweep/obstacle.hpp"

namespace first_contact {

namespace bvh {
struct Parts;
}

/// A mesh with a tree of boxes (bounding volume hierarchy) over its triangles, made for many fast casts.
///
/// The plain way to the same answers is an Environment; plain_bvh.hpp is the plain tree. How the fast one
/// works is told in bvh/build/ (layout.hpp: memory; split.hpp, collapse.hpp, pack.hpp), bvh/kernels/ (casting,
/// eight boxes or triangles at once) and bvh/cast/ (one cast, many, and deciding).
///
/// What it takes, of the time of a plain tree with the sweep of a textbook, which finds a time and no more, is
/// printed by ./course bench.
///
/// What limits it. In a small tree: step waits for step, from the first node to the contact. A walk as good as
/// this one that took the first time it computes for the answer would need two thirds of the time; the rest
/// makes the answer exact and whole: point, normal, feature and triangle, the same on every machine. In a
/// large tree also memory, for which one cast waits and many take turns. A cast that begins in the ground costs
/// more than others here, where it is asked what it goes deeper into, and less in the textbook, whose answer is
/// 0 as soon as it overlaps anything.
class Bvh {
 public:
  /// Builds the tree, on all processors. At most 2^28 triangles.
  /// \throws std::length_error for more.
  explicit Bvh(Mesh mesh);
  ~Bvh();
  /// Takes over another's tree; what is left there may be assigned to, or thrown away.
  Bvh(Bvh&&) noexcept;
  /// The same.
  Bvh& operator=(Bvh&&) noexcept;

  /// The surface.
  const Mesh& mesh() const;
  /// The memory that it needs besides the mesh.
  std::size_t bytes() const;

  /// What it is made of: for its own sweeps, and for tests.
  const bvh::Parts& parts() const { return *parts_; }

 private:
  std::unique_ptr<const bvh::Parts> parts_;
};

/// Do the sphere and the surface share a point? As overlap(sphere, Environment) says it, by the tree.
bool overlap(const Sphere& sphere, const Bvh& bvh);

/// First contact of a moving sphere with a mesh, as sweep(moving, Environment) finds it: the same time,
/// point, normal, feature and triangle, to the last bit, whatever the tree and the machine's instruction set.
///
/// Error: for each triangle let L be the largest distance of its corners from the centre at the start + its
/// longest side + |V| + r. Then the answer is that of exact arithmetic for a radius that differs, for each
/// triangle, by at most 16 eps L = 3.6e-15 L. In other words, with N the normal at the contact:
/// - a sphere that goes deeper than that into a triangle is never missed, and one that stays farther away
/// than that is never said to touch it;
/// - the time is wrong by at most 16 eps L / |N.V|, or sqrt(32 eps L r) / |V| if the sphere only grazes;
/// - a point, r = 0, which cannot go deep, is within that of the triangle at the time of contact, and is not
/// missed if it passes inside all sides, from before the plane to behind it, by more than that.
///
/// The bound is derived with rounding_of_distance (moved_out.hpp): the difference of two points, a cross
/// product, the closest approach and the root, each rounded, move the distance by less than 8 eps L. In a
/// million casts made to be hard the worst was .51 of the bound (./course verify).
std::optional<Contact> sweep(const Moving<Sphere>& moving, const Bvh& bvh);

/// Many casts at once, in turns, so that while one waits for memory others go on. first[i] is what
/// sweep(moving[i], bvh) gives.
/// \throws std::invalid_argument if there are not as many places in `first` as spheres.
void sweep(std::span<const Moving<Sphere>> moving, const Bvh& bvh, std::span<std::optional<Contact>> first);

}  // namespace first_contact
