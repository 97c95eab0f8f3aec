#include "first_contact/bvh/build/cones.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "first_contact/bvh/build/parallel.hpp"

namespace first_contact::bvh {

namespace {

/// More triangles around a vertex are not worth the time.
constexpr std::size_t most_around = 16;
/// Of a triangle that is not thin: its height over its longest side, at least.
constexpr double least_height = 1 / 64.0;
/// So small triangles, in the tree's unit, may be thin for spheres for which cones are asked.
constexpr double least_side = 0x1p-30;
/// The cosine of the widest cone that is of use.
constexpr float widest = 0.25F;

/// Of length 1; zero for a triangle that is thin or small.
Eigen::Vector3f unit_normal(const Triangle& t, const Space& space) {
  const Vector u = space.vector(t.b - t.a), v = space.vector(t.c - t.a), normal = u.cross(v);
  const double area2 = normal.squaredNorm();
  const double longest2 = std::max({u.squaredNorm(), v.squaredNorm(), (v - u).squaredNorm()});
  const bool thick = area2 >= longest2 * least_height * (longest2 * least_height);
  if (!thick || !(longest2 > least_side * least_side)) return Eigen::Vector3f::Zero();
  return (normal / std::sqrt(area2)).cast<float>();
}

/// The vertices after and before a vertex in the triangles around it.
struct Ring {
  std::array<std::uint32_t, most_around> after, before;
  std::size_t count = 0;
  void add(const Mesh::Face& triangle, std::uint32_t vertex) {
    const auto& [a, b, c] = triangle;
    after[count] = vertex == a ? b : vertex == b ? c : a;
    before[count++] = vertex == a ? c : vertex == b ? a : b;
  }
  /// Is each edge passed just twice, once in each direction?
  bool closed() const {
    const auto times = [&](const auto& list, std::uint32_t vertex) {
      return std::count_if(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(count),
                           [&](std::uint32_t other) { return other == vertex; });
    };
    for (std::size_t i = 0; i < count; ++i)
      if (times(after, after[i]) != 1 || times(before, after[i]) != 1) return false;
    return count > 0;
  }
};

}  // namespace

NormalCones::NormalCones(const Surface& surface, const Space& space)
    : surface_(surface), cones_(surface.mesh().vertices().size()) {
  const Mesh& mesh = surface.mesh();
  std::vector<Eigen::Vector3f> normals(mesh.size());
  in_parallel_ranges(mesh.size(), [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) normals[i] = unit_normal(mesh.triangle(i), space);
  });
  in_parallel_ranges(cones_.size(), [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) cones_[i] = cone_at(static_cast<std::uint32_t>(i), normals);
  });
}

//! [cone_at]
NormalCones::Cone NormalCones::cone_at(std::uint32_t vertex,
                                       const std::vector<Eigen::Vector3f>& normals) const {
  Cone none{Eigen::Vector3f::Zero(), 0, 1};
  const auto around = surface_.around(vertex);
  if (around.size() > most_around) return none;
  Ring ring;
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (const std::uint32_t triangle : around) {
    ring.add(surface_.corners(triangle), vertex);
    sum += normals[triangle];
  }
  const Eigen::Vector3f axis = sum.normalized();
  float cosine = 1;
  for (const std::uint32_t triangle : around) cosine = std::min(cosine, axis.dot(normals[triangle]));
  if (!(cosine > widest) || !ring.closed()) return none;
  return {axis, cosine, std::sqrt(std::max(0.0F, 1 - cosine * cosine))};
}
//! [cone_at]

float NormalCones::cosine_around(const Eigen::Vector3f& axis,
                                 std::span<const std::uint32_t> triangles) const {
  float least = 1;
  for (const std::uint32_t triangle : triangles)
    for (const std::uint32_t corner : surface_.corners(triangle)) {
      const Cone& cone = cones_[corner];
      const float along = axis.dot(cone.axis);
      if (!(along > 0) || cone.cosine == 0) return 0;
      const float aside = std::sqrt(std::max(0.0F, 1 - along * along));
      least = std::min(least, along * cone.cosine - aside * cone.sine);
    }
  return std::max(0.0F, least - margin);
}

}  // namespace first_contact::bvh
