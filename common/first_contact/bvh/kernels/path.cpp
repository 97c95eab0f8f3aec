#include "first_contact/bvh/kernels/path.hpp"

#include <algorithm>
#include <cmath>

namespace first_contact::bvh {

namespace {

/// How much the walk must allow for what the doubles round that decide, and for the way into the tree's unit,
/// in terms of all lengths in play. The doubles' distances are wrong by at most rounding_of_distance, 2^-48,
/// of centre to corner + side + path + r, each at most sqrt 3 or 2 sqrt 3 times its largest coordinate; that
/// is less than half of this.
constexpr double error_per_length = 0x1p-44;

/// Slabs pay for themselves from this radius on, in sizes of a leaf.
constexpr float slab_pays = 0.25F;
/// No triangle that has a cone is too thin for a smaller sphere: \see cones.cpp
constexpr float largest_for_cones = 0x1p8F;

/// Written out, so that the three axes are worked out side by side.
template <class Work>
void each_axis(const Work& work) {
  work(0);
  work(1);
  work(2);
}

//! [cut_down]
/// Cuts the path down to its part that is within `reach` of the tree's origin along all three axes, in
/// doubles: what the floats see is never far away. \returns whether there is such a part
bool cut_down(Path& path, double reach) {
  double from = 0, to = 1;
  for (int i = 0; i < 3; ++i) {
    const double start = path.start[i], travel = path.travel[i];
    if (travel == 0 && std::abs(start) > reach) return false;
    if (travel == 0) continue;
    const double low = (-reach - start) / travel, high = (reach - start) / travel;
    from = std::max(from, std::min(low, high));
    to = std::min(to, std::max(low, high));
  }
  if (from > to) return false;
  path.from_time = from;
  path.duration = to - from;
  for (int i = 0; i < 3; ++i) {
    path.start[i] += from * path.travel[i];
    path.travel[i] *= path.duration;
  }
  return true;
}
//! [cut_down]

/// The path in the tree's unit. \returns how far from the tree's origin it leads, at most, along any axis; or
/// less than 0 if it does not come near the mesh
double bring_near(const Tree& tree, const Question& q, Path& path) {
  double near = 0, way = 0;
  each_axis([&](int i) {
    path.start[i] = (q.center[i] - tree.center[i]) * tree.scale;
    path.travel[i] = q.travel[i] * tree.scale;
    near = std::max(near, std::abs(path.start[i]));
    way = std::max(way, std::abs(path.travel[i]));
  });
  path.start[3] = path.travel[3] = 0;
  const double far = near + way;
  path.radius = q.radius * tree.scale;
  const double lengths = 1 + path.radius + far;
  path.error = error_per_length * (tree.offset + lengths);
  path.unsure = static_cast<float>(0x1p-20 * lengths);
  path.from_time = 0;
  path.duration = 1;
  const double reach = (1 + path.radius) * (1 + 0x1p-20) + 2 * path.error;
  if (far <= reach) return far;
  return cut_down(path, reach) ? 3 * reach : -1;
}

/// The path along each axis in floats. A component too small to matter is raised to a size that does no harm,
/// so that nothing here is infinite.
void round_axes(Path& path) {
  constexpr float least_way = box_error * 0x1p-10F;
  float squares = 0;
  each_axis([&](int i) {
    const auto from = static_cast<float>(path.start[i]), across = static_cast<float>(path.travel[i]);
    const bool down = across < 0;
    const float per_way = 1 / std::max(std::abs(across), least_way), grown = path.reach * per_way;
    const float inverse = down ? -per_way : per_way;
    path.from[i] = from;
    path.across[i] = across;
    path.inverse[i] = inverse;
    path.in[i] = -from * inverse - grown;
    path.out[i] = -from * inverse + grown;
    path.near_side[i] = down ? 3 + i : i;
    path.far_side[i] = down ? i : 3 + i;
    squares += across * across;
  });
  path.from[3] = path.across[3] = 0;
  path.length = std::sqrt(squares) * (1 + 0x1p-20F) + 2 * least_way;
}

}  // namespace

bool find_path(const Tree& tree, const Question& q, Path& path) {
  const double farthest = bring_near(tree, q, path);
  if (farthest < 0) return false;
  const float radius = static_cast<float>(path.radius) * (1 + 0x1p-22F);
  const float error =
      (static_cast<float>(std::max(farthest, 1.0)) + radius) * box_error + 2 * static_cast<float>(path.error);
  path.reach = radius + error;
  round_axes(path);
  path.grown_radius = static_cast<float>(path.radius + path.error) * (1 + 0x1p-21F);
  path.bare = radius < largest_for_cones ? radius * (1 - 0x1p-20F) - 2 * error - path.unsure : 0;
  path.brief = path.unsure * path.length * path.length < 32 * radius * radius * radius;
  path.slab_slack = radius > slab_pays * tree.leaf_size ? error : -1;
  return true;
}

}  // namespace first_contact::bvh
