#include "first_contact/partition/bvh/cast.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace first_contact::bvh {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// How much the walk must allow for what the verdict rounds, and for the way into the tree's unit, in terms
/// of all lengths in play. The verdict's distances are wrong by at most rounding_of_distance of centre to
/// corner + side + path + r, each at most sqrt 3 or 2 sqrt 3 times its largest coordinate; that is less than
/// half of this.
constexpr double error_per_length = 256 * eps;

}  // namespace

Cast::Cast(const Moving<Sphere>& moving, const Bvh::Parts& surface, const Walker& walk)
    : parts_(surface), walker_(walk), tree_(surface.tree()), verdict_(*surface.surface, moving) {
  const auto& [center, radius] = moving.shape;
  const Vector& v = moving.displacement;
  question_ = {{center.x(), center.y(), center.z()}, {v.x(), v.y(), v.z()}, radius};
  near_ = surface.mesh.size() > 0 && !moving.displacement.isZero(0) && enter(moving, surface.space);
  if (near_) walker_.begin(tree_, walk_);
}

//! [enter]
/// Cuts the path down to the part that is near the mesh, in doubles: what the floats see is never far away.
bool Cast::enter(const Moving<Sphere>& moving, const Space& space) {
  const Point start = space.point(moving.shape.center);
  const Vector travel = space.vector(moving.displacement);
  walk_.radius = space.length(moving.shape.radius);
  const double offset = space.length(moving.shape.center.cwiseAbs().maxCoeff());
  walk_.error = error_per_length *
                (1 + walk_.radius + offset + start.cwiseAbs().maxCoeff() + travel.cwiseAbs().maxCoeff());

  const double reach = (1 + walk_.radius) * (1 + 0x1p-20) + 2 * walk_.error;
  const bool inside = start.cwiseAbs().maxCoeff() <= reach && (start + travel).cwiseAbs().maxCoeff() <= reach;
  double from = 0, to = 1;
  for (Eigen::Index i = 0; i < 3 && !inside; ++i) {
    if (std::abs(start[i]) > reach && travel[i] == 0) return false;
    if (travel[i] == 0) continue;
    const double low = (-reach - start[i]) / travel[i], high = (reach - start[i]) / travel[i];
    from = std::max(from, std::min(low, high));
    to = std::min(to, std::max(low, high));
  }
  if (from > to) return false;
  from_ = from;
  width_ = to - from;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    walk_.start[i] = start[k] + from * travel[k];
    walk_.travel[i] = width_ * travel[k];
  }
  return true;
}
//! [enter]

void Cast::note_latest() {
  if (verdict_.latest() > 1) return;
  const double tau = (verdict_.latest() - from_ + 4 * eps) / width_;
  if (tau < 1) walk_.latest = static_cast<float>(tau + (std::abs(tau) + 1) * 0x1p-22);
}

void Cast::consider(const Place& place) {
  const Surface& surface = *parts_.surface;
  const auto& [a, b, c] = place.corner;
  const unsigned features =
      walker_.features_in_time(question_, surface.position(a).data(), surface.position(b).data(),
                               surface.position(c).data(), std::min(verdict_.latest(), 1.0));
  verdict_.consider(place, features);
  if (features != 0) note_latest();
}

//! [decide]
/// The nearest first: often it makes the others too late.
void Cast::decide() {
  const Place* places = tree_.places + walk_.leaf->first;
  for (unsigned left = walk_.survivors; left != 0; left &= left - 1)
    for (const std::uint32_t vertex : places[std::countr_zero(left)].corner)
      __builtin_prefetch(&parts_.surface->position(vertex));
  for (unsigned left = walk_.survivors; left != 0;) {
    int nearest = std::countr_zero(left);
    for (unsigned others = left & (left - 1); others != 0; others &= others - 1)
      if (walk_.bound[std::countr_zero(others)] < walk_.bound[nearest]) nearest = std::countr_zero(others);
    if (walk_.bound[nearest] > walk_.latest) return;
    consider(places[nearest]);
    left &= ~(1u << nearest);
  }
}
//! [decide]

void Cast::run() {
  if (!near_) return;
  while (walker_.next(tree_, walk_) == Stop::survivors) decide();
}

bool Cast::step() {
  if (!near_) return false;
  const Stop stop = walker_.step(tree_, walk_);
  if (stop == Stop::survivors) decide();
  return stop != Stop::end;
}

}  // namespace first_contact::bvh
