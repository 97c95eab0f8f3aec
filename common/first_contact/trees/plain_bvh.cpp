#include "first_contact/trees/plain_bvh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "first_contact/sweep/known_environment.hpp"

namespace first_contact {

namespace {

/// What the tests of triangles and of boxes round, in terms of all lengths in play:
/// \see rounding_of_distance
constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();

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
