#include "first_contact/bvh/cast/sphere_cast.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "first_contact/geometry/unit_scale.hpp"

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

SphereCast::SphereCast(const Moving<Sphere>& moving, const Parts& parts, const Walker& walker)
    : parts_(parts), walker_(walker), tree_(parts.tree), verdict_(parts, moving) {
  const Vector& v = moving.displacement;
  question_ = {moving.shape.center.data(), v.data(), moving.shape.radius};
  near_ = parts.mesh.size() > 0 && !v.isZero(0) && find_path(tree_, question_, walk_.path);
  start(tree_, walk_.progress);
  const Point& middle = parts.space.center();
  const double size = std::max(largest(v), moving.shape.radius), mesh = 1 / parts.space.scale();
  ordinary_ = is_ordinary(size) && std::max({largest(moving.shape.center), largest(middle), mesh}) <= 0x1p79;
}

void SphereCast::note_latest() {
  const double latest = std::min(verdict_.latest(), hoped_);
  if (latest > 1) return;
  const double tau = (latest - walk_.path.from_time + 4 * eps) / walk_.path.duration;
  if (tau < walk_.progress.latest)
    walk_.progress.latest = static_cast<float>(tau + (std::abs(tau) + 1) * 0x1p-22);
}

//! [consider]
/// What may be touched at the start is decided at once: of it one may yet get free.
void SphereCast::consider(const LeafFace& face, bool overlapping) {
  constexpr unsigned all_features = 0x7f;
  if (!ordinary_) {  // the bounds are for lengths whose products are; the verdict chooses a unit
    verdict_.consider(face, all_features);
    return note_latest();
  }
  const std::vector<Point>& position = parts_.mesh.vertices();
  const auto& [a, b, c] = face.corner;
  const double latest = std::min({verdict_.latest(), hoped_, 1.0});
  const Found found = walker_.features_in_time(question_, position[a].data(), position[b].data(),
                                               position[c].data(), latest, overlapping);
  if (overlapping || !hopeful_ || found.features == 0) {
    verdict_.consider(face, found.features, found.within);
  } else {
    if (postponed_count_ == postponed_.size()) consider_postponed();
    postponed_[postponed_count_++] = {face, earliest(found), found};
    hoped_ = std::min(hoped_, found.late);
  }
  if (found.features != 0) note_latest();
}

/// Decides about a triangle that survives. If the walk is certain about its face, no feature has to be asked.
void SphereCast::decide_about(const LeafFace& face, int lane) {
  const Progress& at = walk_.progress;
  const bool overlapping = at.early[lane] <= 0;
  if (at.untouched >> lane & 1) {
    verdict_.consider(face, 0);
  } else if (!(at.touched >> lane & 1)) {
    consider(face, overlapping);
  } else if (overlapping || !hopeful_) {
    verdict_.consider(face, 1, true);
    note_latest();
  } else {
    postpone_face(face, time_of(at.early[lane]), time_of(at.late[lane]));
  }
}

/// A face that is touched for certain, between these times.
void SphereCast::postpone_face(const LeafFace& face, double early, double late) {
  if (postponed_count_ == postponed_.size()) consider_postponed();
  Postponed& postponed = postponed_[postponed_count_++];
  postponed.face = face;
  postponed.early = postponed.found.early[0] = early;
  postponed.found.features = 1;
  postponed.found.within = true;
  hoped_ = std::min(hoped_, late);
}

void SphereCast::consider_postponed() {
  const auto end = postponed_.begin() + static_cast<std::ptrdiff_t>(postponed_count_);
  if (postponed_count_ > 1)
    std::sort(postponed_.begin(), end,
              [](const Postponed& p, const Postponed& q) { return p.early < q.early; });
  std::for_each(postponed_.begin(), end, [&](const Postponed& p) {
    verdict_.consider(p.face, by(std::min(verdict_.latest(), hoped_), p.found), p.found.within);
  });
  postponed_count_ = 0;
}

/// If nothing was touched by the time that was hoped for, begins once more, without hope.
bool SphereCast::finish() {
  if (postponed_count_ > 0) consider_postponed();
  if (!near_ || !hopeful_ || hoped_ > 1 || verdict_.latest() <= hoped_) return true;
  hopeful_ = false;
  hoped_ = 2;
  verdict_.forget();
  start(tree_, walk_.progress);
  return false;
}
//! [consider]

Pause SphereCast::fetch_corners() const {
  const LeafHead& leaf = *walk_.progress.leaf;
  for (unsigned left = walk_.progress.survivors; left != 0; left &= left - 1)
    for (const std::uint32_t vertex : face_of(leaf, std::countr_zero(left)).corner)
      __builtin_prefetch(&parts_.mesh.vertices()[vertex]);
  return Pause::corners;
}

//! [decide]
/// The nearest first: often it makes the others too late.
void SphereCast::decide_leaf() {
  const Progress& at = walk_.progress;
  for (unsigned left = at.survivors; left != 0;) {
    int nearest = std::countr_zero(left);
    for (unsigned others = left & (left - 1); others != 0; others &= others - 1)
      if (at.early[std::countr_zero(others)] < at.early[nearest]) nearest = std::countr_zero(others);
    if (at.early[nearest] > at.latest) return;
    decide_about(face_of(*at.leaf, nearest), nearest);
    left &= ~(1U << nearest);
  }
}
//! [decide]

Pause SphereCast::decide() {
  decide_leaf();
  return walker_.resume(walk_);
}

void SphereCast::run() {
  if (!near_) return;
  do
    while (walker_.advance(tree_, walk_) == Pause::survivors) {
      if ((walk_.progress.survivors & (walk_.progress.survivors - 1)) != 0) fetch_corners();
      decide_leaf();
    }
  while (!finish());
}

std::optional<Contact> sweep(const Moving<Sphere>& moving, const Parts& parts, const Walker& walker) {
  SphereCast cast(moving, parts, walker);
  cast.run();
  return cast.contact();
}

}  // namespace first_contact::bvh
