#include "first_contact/partition/bvh/cast.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace first_contact::bvh {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// Calls visit(feature) for each feature that was found.
template <class Visit>
void each_feature(const Found& found, const Visit& visit) {
  for (unsigned left = found.features; left != 0; left &= left - 1) visit(std::countr_zero(left));
}
double earliest(const Found& found) {
  double early = 2;
  each_feature(found, [&](int i) { early = std::min(early, found.early[i]); });
  return early;
}
/// The features that may be touched by a time.
unsigned by(double time, const Found& found) {
  unsigned features = 0;
  each_feature(found, [&](int i) { features |= found.early[i] <= time ? 1U << i : 0U; });
  return features;
}

}  // namespace

Cast::Cast(const Moving<Sphere>& moving, const Bvh::Parts& surface, const Walker& walk)
    : parts_(surface), walker_(walk), tree_(surface.tree), verdict_(*surface.surface, moving) {
  const Vector& v = moving.displacement;
  question_ = {moving.shape.center.data(), v.data(), moving.shape.radius};
  near_ = surface.mesh.size() > 0 && !v.isZero(0) && walker_.begin(tree_, question_, walk_);
}

void Cast::note_latest() {
  const double latest = std::min(verdict_.latest(), hoped_);
  if (latest > 1) return;
  if (verdict_.depth() > 0) {
    const double depth = parts_.space.length(verdict_.depth());
    walk_.latest = static_cast<float>(walk_.radius * 0x1p-22 - depth);
    return;
  }
  const double tau = (latest - walk_.from_time + 4 * eps) / walk_.duration;
  if (tau < walk_.latest) walk_.latest = static_cast<float>(tau + (std::abs(tau) + 1) * 0x1p-22);
}

//! [consider]
/// What may be touched at the start is decided at once: of it one may yet get free.
void Cast::consider(const Place& place, bool overlapping) {
  const Surface& surface = *parts_.surface;
  const auto& [a, b, c] = place.corner;
  const double latest = std::min({verdict_.latest(), hoped_, 1.0});
  const Found found =
      walker_.features_in_time(question_, surface.position(a).data(), surface.position(b).data(),
                               surface.position(c).data(), latest, overlapping);
  if (overlapping || !hopeful_ || found.features == 0) {
    verdict_.consider(place, found.features, found.within);
  } else {
    if (postponed_count_ == postponed_.size()) consider_postponed();
    postponed_[postponed_count_++] = {&place, found, earliest(found)};
    hoped_ = std::min(hoped_, found.late);
  }
  if (found.features != 0) note_latest();
}

void Cast::consider_postponed() {
  const auto end = postponed_.begin() + static_cast<std::ptrdiff_t>(postponed_count_);
  std::sort(postponed_.begin(), end,
            [](const Postponed& p, const Postponed& q) { return p.early < q.early; });
  std::for_each(postponed_.begin(), end, [&](const Postponed& p) {
    verdict_.consider(*p.place, by(std::min(verdict_.latest(), hoped_), p.found), p.found.within);
  });
  postponed_count_ = 0;
}

/// Decides about what was postponed. If nothing was touched by the time that was hoped for, begins once more,
/// without hope.
bool Cast::done() {
  consider_postponed();
  if (!hopeful_ || hoped_ > 1 || verdict_.latest() <= hoped_) return true;
  hopeful_ = false;
  hoped_ = 2;
  verdict_.forget();
  walker_.begin(tree_, question_, walk_);
  return false;
}
//! [consider]

void Cast::fetch_places() const {
  const Place* places = tree_.places + walk_.leaf->first;
  for (unsigned left = walk_.survivors; left != 0; left &= left - 1)
    __builtin_prefetch(&places[std::countr_zero(left)]);
}

void Cast::fetch_corners() const {
  const Place* places = tree_.places + walk_.leaf->first;
  for (unsigned left = walk_.survivors; left != 0; left &= left - 1)
    for (const std::uint32_t vertex : places[std::countr_zero(left)].corner)
      __builtin_prefetch(&parts_.surface->position(vertex));
}

//! [decide]
/// The nearest first: often it makes the others too late.
void Cast::decide() {
  const Place* places = tree_.places + walk_.leaf->first;
  for (unsigned left = walk_.survivors; left != 0;) {
    int nearest = std::countr_zero(left);
    for (unsigned others = left & (left - 1); others != 0; others &= others - 1)
      if (walk_.bound[std::countr_zero(others)] < walk_.bound[nearest]) nearest = std::countr_zero(others);
    if (walk_.bound[nearest] > walk_.latest) return;
    consider(places[nearest], walk_.bound[nearest] <= 0);
    left &= ~(1U << nearest);
  }
}
//! [decide]

void Cast::run() {
  if (!near_) return;
  do
    while (walker_.next(tree_, walk_) == Stop::survivors) {
      fetch_corners();
      decide();
    }
  while (!done());
}

bool Cast::step() {
  if (!near_) return false;
  switch (awaited_) {
    case Awaited::tree: {
      const Stop stop = walker_.step(tree_, walk_);
      if (stop == Stop::end) return !done();
      if (stop == Stop::survivors) {
        fetch_places();
        awaited_ = Awaited::places;
      }
      break;
    }
    case Awaited::places:
      fetch_corners();
      awaited_ = Awaited::corners;
      break;
    case Awaited::corners:
      decide();
      awaited_ = Awaited::tree;
  }
  return true;
}

}  // namespace first_contact::bvh
