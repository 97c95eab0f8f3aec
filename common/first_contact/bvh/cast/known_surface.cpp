#include "first_contact/bvh/cast/known_surface.hpp"

#include <cmath>
#include <limits>

#include "first_contact/geometry/products.hpp"

namespace first_contact::bvh {

namespace {

bool has(const Place& place, std::uint32_t vertex) {
  return place.corner[0] == vertex || place.corner[1] == vertex || place.corner[2] == vertex;
}

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

//! [lead]
/// Where do the faces around a touched vertex (from = to) or edge lead, by much more than rounding? If all
/// bend away from the sphere, then none of them is nearer, none has the touch's normal, the edge is not flat
/// and the vertex is not buried: the normal itself shows the way out. If one comes nearer, something else is
/// touched before. What is not clear goes to the functions that weigh the rounding.
Lead KnownSurface::lead(const Touch& touch, std::uint32_t from, std::uint32_t to) const {
  constexpr double much = 1e-6;  // radians
  // The angle up to which nearest.cpp takes two directions for one, twice over.
  const double in_doubt = 2 * std::sqrt(touch.tolerance * (2 * touch.distance + touch.tolerance));
  if (!(in_doubt < 0.5 * touch.distance)) return Lead::in_doubt;
  const double sine = std::max(much, in_doubt / touch.distance);
  const Vector edge = position(to) - position(from);
  bool all_away = true;
  const auto leads_nearer = [&](const Place& place) {
    for (const std::uint32_t corner : place.corner) {
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
    const Place& place = *first_[i];
    if (has(place, from) && has(place, to) && leads_nearer(place)) return Lead::nearer;
  }
  for (const std::uint32_t at : surface_.around(from)) {
    const Place& place = surface_.places()[at];
    if (has(place, to) && leads_nearer(place)) return Lead::nearer;
  }
  return all_away ? Lead::away : Lead::in_doubt;
}
//! [lead]

std::vector<FaceAt> KnownSurface::faces_at(std::uint32_t from, std::uint32_t to) const {
  std::vector<FaceAt> faces;
  for (const std::uint32_t at : surface_.around(from)) {
    const Place& place = surface_.places()[at];
    const auto& [a, b, c] = place.corner;
    if (has(place, to)) faces.push_back({place.number, {a, b, c}, Facet(surface_.triangle(place))});
  }
  return faces;
}

std::uint32_t KnownSurface::lowest_face_at(std::uint32_t from, std::uint32_t to) const {
  for (const std::uint32_t at : surface_.around(from))
    if (has(surface_.places()[at], to)) return surface_.places()[at].number;
  return 0;
}

}  // namespace first_contact::bvh
