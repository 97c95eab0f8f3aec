#include "first_contact/bvh/cast/known_surface.hpp"

#include <cmath>
#include <limits>

#include "first_contact/geometry/products.hpp"

namespace first_contact::bvh {

namespace {

bool has(const LeafFace& face, std::uint32_t vertex) {
  return face.corner[0] == vertex || face.corner[1] == vertex || face.corner[2] == vertex;
}

/// No face's number.
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// Is a face with these two sides far from being too thin to answer for itself (\see Facet::thin_for), and
/// its normal right to much less than a millionth?
bool clearly_thick(const Vector& u, const Vector& v, double radius) {
  constexpr double eps = std::numeric_limits<double>::epsilon();
  const double longest2 = std::max({squared_norm(u), squared_norm(v), squared_norm(v - u)});
  const double thin =
      std::max(1e-12 * longest2, 4 * eps * radius * std::sqrt(longest2));  // squares of its height
  return squared_norm(u.cross(v)) > thin * longest2;
}

}  // namespace

//! [each_face_at]
/// Calls visit(face) for each face that has two vertices, which may be the same, as the leaves have them.
template <class Visit>
void KnownSurface::each_face_at(std::uint32_t from, std::uint32_t to, const Visit& visit) const {
  for (const Ref ref : parts_.leaves_at.of(from)) {
    const LeafHead& leaf = leaf_at(parts_.tree.leaves, ref);
    for (int j = 0; j < leaf.triangles; ++j) {
      const LeafFace face = face_of(leaf, j);
      if (has(face, from) && has(face, to)) visit(face);
    }
  }
}
//! [each_face_at]

//! [lead]
/// Where do the faces around a touched vertex (from = to) or edge lead, by much more than rounding? If all
/// bend away from the sphere, then none of them is nearer, none has the touch's normal, the edge is not flat
/// and the vertex is not buried: the normal itself shows the way out. If one comes nearer, something else is
/// touched before. What is not clear goes to the functions that weigh the rounding.
FacesAround KnownSurface::around(const Touch& touch, std::uint32_t from, std::uint32_t to) const {
  constexpr double much = 1e-6;  // radians
  // The angle up to which nearest.cpp takes two directions for one, twice over.
  const double in_doubt = 2 * std::sqrt(touch.tolerance * (2 * touch.distance + touch.tolerance));
  if (!(in_doubt < 0.5 * touch.distance)) return {Lead::in_doubt, none};
  const double sine = std::max(much, in_doubt / touch.distance);
  const Vector edge = position(to) - position(from);
  bool all_away = true;
  const auto leads_nearer = [&](const LeafFace& face) {
    for (const std::uint32_t corner : face.corner) {
      if (corner == from || corner == to) continue;
      const Vector way = position(corner) - position(from);
      const double rise = dot(touch.normal, way);
      const bool clear = rise * rise > sine * sine * std::max(squared_norm(edge), squared_norm(way));
      if (clear && rise > 0 && (from == to || clearly_thick(edge, way, radius_))) return true;
      all_away = all_away && clear && rise < 0;
    }
    return false;
  };
  // What was considered is at hand, and most often says so already.
  for (std::size_t i = 0; i < count_; ++i) {
    const LeafFace& face = first_[i];
    if (has(face, from) && has(face, to) && leads_nearer(face)) return {Lead::nearer, none};
  }
  bool nearer = false;
  std::uint32_t lowest = none;
  each_face_at(from, to, [&](const LeafFace& face) {
    lowest = std::min(lowest, face.number);
    nearer = nearer || leads_nearer(face);
  });
  return {nearer ? Lead::nearer : all_away ? Lead::away : Lead::in_doubt, lowest};
}
//! [lead]

std::vector<FaceAt> KnownSurface::faces_at(std::uint32_t from, std::uint32_t to) const {
  std::vector<LeafFace> found;
  each_face_at(from, to, [&](const LeafFace& face) { found.push_back(face); });
  std::sort(found.begin(), found.end(),
            [](const LeafFace& f, const LeafFace& g) { return f.number < g.number; });
  std::vector<FaceAt> faces;
  for (const LeafFace& face : found) faces.push_back({face.number, face.corner, facet(face)});
  return faces;
}

}  // namespace first_contact::bvh
