#pragma once
#include <cstdint>
#include <optional>

#include "first_contact/geometry/mesh.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/sweep/contact.hpp"

/// \file
/// Is an answer of a sweep true, within the bound that bvh.hpp states?

namespace judge {

using namespace first_contact;

/// Counts of casts, and of what was wrong about their answers.
struct Tally {
  std::uint64_t casts = 0, hits = 0;
  std::uint64_t overlaps = 0;  ///< casts that overlap the surface at the start
  std::uint64_t grazes = 0;    ///< to hit or not to hit is decided by less than the bound
  std::uint64_t disputed = 0;  ///< 64 bits found fault with a sphere, and 50 digits were asked
  std::uint64_t missed = 0, false_hits = 0;
  std::uint64_t inexact = 0;  ///< the time is outside the bound, or the distance at that time
  std::uint64_t unlike = 0;   ///< two ways to the same answer differ
  double worst = 0;           ///< how wrong the distance is at the time of contact, in bounds

  void add(const Tally& t);
  bool good() const { return missed + false_hits + inexact + unlike == 0; }
};

/// Judges an answer and counts the verdict.
void add(Tally& tally, const Mesh& mesh, const Moving<Sphere>& moving, const std::optional<Contact>& contact);

/// The same in all but name, to the last bit?
bool same(const std::optional<Contact>& a, const std::optional<Contact>& b);

/// Makes the surface and the casts of a seed, and judges all ways to the answer: the fast tree on this
/// machine's instructions and on portable ones, one cast after the other and in a batch, and the plain tree.
/// \param tallies one for each aim
/// \see surfaces.hpp
void verify(std::uint64_t seed, int kind, int casts, Tally* tallies);

}  // namespace judge
