#include "verify/judge.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstdio>
#include <limits>
#include <vector>

#include "first_contact/bvh/bvh.hpp"
#include "first_contact/bvh/cast/parts.hpp"
#include "first_contact/bvh/cast/sphere_cast.hpp"
#include "first_contact/trees/plain_bvh.hpp"
#include "verify/surfaces.hpp"
#include "verify/window.hpp"
#include "wide.hpp"

namespace judge {

namespace {

using FiftyDigits = boost::multiprecision::cpp_bin_float_50;

template <class Real>
Tally tally_of(const Mesh& mesh, const Moving<Sphere>& moving, const std::optional<Contact>& contact) {
  Tally tally;
  tally.hits = contact.has_value();
  const auto all = witnesses<Real>(mesh, moving);
  const Real r = moving.shape.radius;
  bool overlaps = false;
  for (const Witness<Real>& one : all) overlaps |= one.overlaps;
  const auto [earliest, latest] = overlaps ? from_overlap(all, moving) : from_apart(all, moving);
  tally.overlaps = overlaps;
  tally.grazes = earliest && !latest;
  tally.missed = latest && !contact;
  tally.false_hits = !earliest && contact;
  if (!contact || !earliest) return tally;
  const Real t = contact->time;
  tally.inexact = t < *earliest || (latest && t > *latest);
  if (overlaps) return tally;
  Real least = std::numeric_limits<Real>::infinity();
  for (const Witness<Real>& one : all) {
    const Real error = abs(one.approach.distance(t) - r) / one.bound;
    if (error < least) least = error;
  }
  tally.worst = static_cast<double>(least);
  tally.inexact |= least > 1;
  return tally;
}

}  // namespace

void Tally::add(const Tally& t) {
  casts += t.casts;
  hits += t.hits;
  overlaps += t.overlaps;
  grazes += t.grazes;
  disputed += t.disputed;
  missed += t.missed;
  false_hits += t.false_hits;
  inexact += t.inexact;
  unlike += t.unlike;
  worst = std::max(worst, t.worst);
}

/// 64 bits may acquit the answer for a sphere: their distances are right to 2^-60 L, and how a distance of r
/// changes is then known as well. They may not for a point: near to 0 nothing is known of that.
void add(Tally& tally, const Mesh& mesh, const Moving<Sphere>& moving,
         const std::optional<Contact>& contact) {
  const bool sphere = moving.shape.radius > 0;
  Tally one;
  if (sphere) one = tally_of<Wide>(mesh, moving, contact);
  if (!sphere || !one.good()) {
    one = tally_of<FiftyDigits>(mesh, moving, contact);
    one.disputed = sphere;
  }
  one.casts = 1;
  tally.add(one);
}

bool same(const std::optional<Contact>& a, const std::optional<Contact>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->time == b->time && a->points == b->points && a->normal == b->normal && a->feature == b->feature &&
         a->triangle == b->triangle;
}

void verify(std::uint64_t seed, int kind, int count, Tally* tallies) {
  surfaces::Random random(seed);
  const Mesh mesh = surfaces::placed(surfaces::surface(kind, random), random);
  const Bvh fast(mesh);
  const PlainBvh plain(mesh);
  static const auto walkers = bvh::all_walkers();
  std::vector<Moving<Sphere>> casts;
  for (int i = 0; i < count; ++i) casts.push_back(surfaces::cast(mesh, i % surfaces::aims, random));
  std::vector<std::optional<Contact>> together(casts.size());
  sweep(casts, fast, together);
  for (std::size_t i = 0; i < casts.size(); ++i) {
    Tally& tally = tallies[i % surfaces::aims];
    const auto contact = sweep(casts[i], fast);
    const bool all_walk_alike = std::all_of(walkers.begin(), walkers.end(), [&](const bvh::Walker* walker) {
      return same(contact, bvh::sweep(casts[i], fast.parts(), *walker));
    });
    if (!all_walk_alike || !same(contact, together[i]) || !same(contact, sweep(casts[i], plain)))
      ++tally.unlike;
    const Tally before = tally;
    add(tally, mesh, casts[i], contact);
    if (before.good() && !tally.good())
      std::fprintf(stderr, "wrong: %s, seed %llu, cast %zu\n", surfaces::name(kind),
                   static_cast<unsigned long long>(seed), i);
  }
}

}  // namespace judge
