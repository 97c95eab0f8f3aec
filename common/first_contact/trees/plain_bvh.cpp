#include "first_contact/trees/plain_bvh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "first_contact/geometry/unit_scale.hpp"
#include "first_contact/sweep/known_environment.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"

namespace first_contact {

namespace {

/// What the tests of triangles and of boxes round, in terms of all lengths in play:
/// \see rounding_of_distance
constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();

/// May the sphere touch what is in the box?
bool reaches(const Sphere& sphere, const Bounds& box) {
  const auto& [center, radius] = sphere;
  const Point nearest = center.cwiseMax(box.min()).cwiseMin(box.max());
  return within(center - nearest, radius + rounding * (largest(center) + largest_coordinate(box) + radius));
}

}  // namespace

PlainBvh::Path::Path(const Moving<Sphere>& moving)
    : start(moving.shape.center), inverse(moving.displacement.cwiseInverse()), radius(moving.shape.radius) {
  radius += rounding * (start.cwiseAbs().maxCoeff() + moving.displacement.cwiseAbs().maxCoeff() + radius);
}

//! [entry_plain_bvh]
/// When the centre enters the box grown by the radius, in [0, latest]; infinite if it does not (the slab test
/// of Kay and Kajiya). Grown again by what is rounded; an axis along which nothing moves gives infinite times
/// of the right signs, or 0 times infinity if the start is just on the border, which excludes nothing.
double PlainBvh::Path::entry(const Bounds& box, double latest) const {
  double enter = 0, leave = latest;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double low = box.min()[i], high = box.max()[i];
    const double grown = radius + rounding * std::max(std::abs(low), std::abs(high));
    const double low_time = (low - grown - start[i]) * inverse[i],
                 high_time = (high + grown - start[i]) * inverse[i];
    const double first = inverse[i] < 0 ? high_time : low_time, last = inverse[i] < 0 ? low_time : high_time;
    if (first > enter) enter = first;
    if (last < leave) leave = last;
  }
  return enter <= leave ? enter : std::numeric_limits<double>::infinity();
}
//! [entry_plain_bvh]

bool overlap(const Sphere& sphere, const PlainBvh& tree) {
  std::vector<std::size_t> waiting;
  if (tree.mesh().size() > 0) waiting.push_back(0);
  while (!waiting.empty()) {
    const BoxTreeNode& node = tree.tree().node(waiting.back());
    waiting.pop_back();
    if (!reaches(sphere, node.bounds)) continue;
    for (std::uint32_t i = node.begin; node.is_leaf() && i < node.end; ++i)
      if (overlap(sphere, tree.mesh().triangle(tree.tree().order()[i]))) return true;
    if (!node.is_leaf()) waiting.insert(waiting.end(), {node.first_child, node.first_child + 1});
  }
  return false;
}

//! [sweep_plain_bvh]
std::optional<Contact> sweep(const Moving<Sphere>& moving, const PlainBvh& tree) {
  if (moving.displacement.isZero(0)) return std::nullopt;
  const KnownEnvironment known(tree.environment());
  FirstTouch<KnownEnvironment> first(known, moving);
  tree.visit(moving, [&](std::uint32_t triangle) {
    const auto corners = known.corners(triangle);
    first.face(triangle, corners, tree.environment().facet(triangle));
    for (std::size_t i = 0; i < 3; ++i)
      if (corners[i] != corners[(i + 1) % 3]) first.edge(corners[i], corners[(i + 1) % 3]);
    for (const std::uint32_t corner : corners) first.vertex(corner);
    return first.latest();
  });
  return first.contact();
}
//! [sweep_plain_bvh]

}  // namespace first_contact
