#include "first_contact/bvh/cast/verdict.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "first_contact/geometry/closest_point.hpp"
#include "first_contact/geometry/mesh_edges.hpp"
#include "first_contact/geometry/products.hpp"
#include "first_contact/sweep/nearest.hpp"

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

/// Does the point lie within the triangle's box, to the tolerance? Much quicker than the nearest point.
bool in_box(const Point& p, const Point& a, const Point& b, const Point& c, double tolerance) {
  const Vector low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
  return (p.array() >= low.array() - tolerance).all() && (p.array() <= high.array() + tolerance).all();
}

}  // namespace

template <class Key>
bool Verdict::Recent<Key>::seen(const Key& k) {
  if (!filled) key.fill(0);
  filled = true;
  Key& place = key[(k ^ k / key.size()) % key.size()];
  const bool known = place == k + 1;
  place = k + 1;
  return known;
}

void Verdict::consider(const Place& place, unsigned features, bool within_face) {
  considered_.add(place);
  if (features == 0) return;
  const auto& corners = place.corner;
  if (features & 1)
    keep(touch_face(moving_, Facet(surface_.triangle(place)), within_face),
         {corners[0], corners[1], corners[2]}, place.number);
  for (unsigned left = features >> 1; left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(left));
    if (i < 3)
      consider_edge(corners[i], corners[(i + 1) % 3]);
    else
      consider_vertex(corners[i - 3]);
  }
}

void Verdict::forget() {
  first_.reset();
  considered_.count = 0;
  considered_.more.clear();
  edges_.filled = vertices_seen_.filled = false;
}

void Verdict::consider_edge(std::uint32_t p, std::uint32_t q) {
  const auto [low, high] = std::minmax(p, q);
  if (low == high || edges_.seen(std::uint64_t{low} << 32 | high)) return;
  const bool turned = comes_before(position(high), position(low));
  const std::uint32_t from = turned ? high : low, to = turned ? low : high;
  const auto touch = touch_edge(moving_, position(from), position(to));
  if (!too_late(touch)) keep_edge(*touch, from, to);
}

void Verdict::consider_vertex(std::uint32_t vertex) {
  if (vertices_seen_.seen(vertex)) return;
  const auto touch = touch_vertex(moving_, position(vertex));
  if (!too_late(touch)) keep_vertex(*touch, vertex);
}

//! [surroundings]
/// Where do the faces around a touched vertex (from = to) or edge lead, by much more than rounding? If all
/// bend away from the sphere, then none of them is nearer, none has the touch's normal, the edge is not flat
/// and the vertex is not buried: the normal itself shows the way out. If one comes nearer, something else is
/// touched before. What is not clear goes to the functions that weigh the rounding.
Verdict::Surroundings Verdict::surroundings(const Touch& touch, std::uint32_t from, std::uint32_t to) const {
  constexpr double much = 1e-6;  // radians
  // The angle up to which nearest.cpp takes two directions for one, twice over.
  const double in_doubt = 2 * std::sqrt(touch.tolerance * (2 * touch.distance + touch.tolerance));
  if (!(in_doubt < 0.5 * touch.distance)) return Surroundings::in_doubt;
  const double sine = std::max(much, in_doubt / touch.distance);
  const Vector edge = position(to) - position(from);
  bool all_away = true;
  const auto leads_nearer = [&](const Place& place) {
    for (const std::uint32_t corner : place.corner) {
      if (corner == from || corner == to) continue;
      const Vector way = position(corner) - position(from);
      const double rise = dot(touch.normal, way);
      const bool clear = rise * rise > sine * sine * std::max(squared_norm(edge), squared_norm(way));
      if (clear && rise > 0 && (from == to || clearly_thick(edge, way, moving_.shape.radius))) return true;
      all_away = all_away && clear && rise < 0;
    }
    return false;
  };
  // What was considered is at hand, and most often says so already.
  for (std::size_t i = 0; i < considered_.count; ++i) {
    const Place& place = *considered_.first[i];
    if (has(place, from) && has(place, to) && leads_nearer(place)) return Surroundings::lead_nearer;
  }
  for (const std::uint32_t at : surface_.around(from)) {
    const Place& place = surface_.places()[at];
    if (has(place, to) && leads_nearer(place)) return Surroundings::lead_nearer;
  }
  return all_away ? Surroundings::lead_away : Surroundings::in_doubt;
}
//! [surroundings]

/// The lowest number of a face with this edge, or, if from = to, vertex.
std::uint32_t Verdict::first_face(std::uint32_t from, std::uint32_t to) const {
  for (const std::uint32_t at : surface_.around(from))
    if (has(surface_.places()[at], to)) return surface_.places()[at].number;
  return 0;
}

/// Does the surface go straight on from one face to the other, so that their edge is but a seam?
bool Verdict::is_seam(const std::vector<Facet>& facets, const std::vector<Vector>& along) const {
  const auto thin = [&](const Facet& facet) { return facet.thin_for(moving_.shape.radius); };
  if (facets.size() != 2 || thin(facets[0]) || thin(facets[1])) return false;
  return kind_of(facets[0], facets[1], along[0], dot(along[0], along[1]) < 0) == EdgeKind::flat;
}

void Verdict::keep_edge(const Touch& touch, std::uint32_t from, std::uint32_t to) {
  const std::array<std::uint32_t, 3> vertices{from, to, to};
  const Surroundings around = surroundings(touch, from, to);
  if (around == Surroundings::lead_nearer) return;
  if (around == Surroundings::lead_away) return keep(touch, vertices, first_face(from, to));

  struct Side {
    const Place* place;
    std::size_t slot;
  };
  std::vector<Side> sides;
  for (const std::uint32_t at : surface_.around(from)) {
    const Place& place = surface_.places()[at];
    for (std::size_t slot = 0; slot < 3; ++slot) {
      const std::uint32_t p = place.corner[slot], q = place.corner[(slot + 1) % 3];
      if ((p == from && q == to) || (p == to && q == from)) sides.push_back({&place, slot});
    }
  }
  std::vector<Facet> facets;
  std::vector<FaceAround> faces;
  std::vector<Vector> along;
  facets.reserve(sides.size());
  for (const auto& [place, slot] : sides) {
    const Facet& facet = facets.emplace_back(surface_.triangle(*place));
    const std::array<Point, 3> corners{facet.triangle.a, facet.triangle.b, facet.triangle.c};
    along.emplace_back(corners[(slot + 1) % 3] - corners[slot]);
    faces.push_back({&facet, facet.normal.cross(along.back())});
  }
  const auto judged = among_faces(touch, faces, moving_);
  if (!judged || (judged->feature == Feature::edge && is_seam(facets, along))) return;
  keep(judged, vertices, sides[0].place->number);
}

void Verdict::keep_vertex(const Touch& touch, std::uint32_t vertex) {
  const Surroundings clear = surroundings(touch, vertex, vertex);
  if (clear == Surroundings::lead_nearer) return;
  const auto around = surface_.around(vertex);
  const std::uint32_t lowest = surface_.places()[around[0]].number;
  if (clear == Surroundings::lead_away) return keep(touch, {vertex, vertex, vertex}, lowest);

  std::vector<std::uint32_t> others;
  std::vector<Facet> facets;
  std::vector<FaceAround> faces;
  facets.reserve(around.size());
  for (const std::uint32_t at : around) {
    const Place& place = surface_.places()[at];
    for (const std::uint32_t corner : place.corner)
      if (corner != vertex) others.push_back(corner);
    faces.push_back({&facets.emplace_back(surface_.triangle(place)), Vector::Zero()});
  }
  std::sort(others.begin(), others.end(),
            [&](std::uint32_t p, std::uint32_t q) { return surface_.number(p) < surface_.number(q); });
  others.erase(std::unique(others.begin(), others.end()), others.end());
  std::vector<Vector> edges, directions;
  for (const std::uint32_t other : others) {
    edges.emplace_back(position(other) - position(vertex));
    directions.emplace_back(normalized(edges.back()));
  }
  const auto judged = among_edges(touch, edges, faces, moving_);
  if (!judged || (judged->feature == Feature::vertex && !edges.empty() && buried_by(directions))) return;
  keep(judged, {vertex, vertex, vertex}, lowest);
}

/// Of features touched all alike, the one of the lower triangle, and then of the lower vertices, by their
/// numbers in the mesh.
bool Verdict::comes_first(const Vertices& vertices, std::uint32_t face) const {
  const auto key = [&](std::uint32_t number, const Vertices& v) {
    return std::array{number, surface_.number(v[0]), surface_.number(v[1]), surface_.number(v[2])};
  };
  return key(face, vertices) < key(face_, vertices_);
}

void Verdict::keep(const std::optional<Touch>& touch, const Vertices& vertices, std::uint32_t face) {
  if (!touch) return;
  if (first_ && !earlier(*touch, *first_)) {
    const bool alike = !earlier(*first_, *touch);
    if (!alike || !comes_first(vertices, face)) return;
  }
  first_ = touch;
  vertices_ = vertices;
  face_ = face;
}

/// Does a face at one of the touched feature's vertices reach the touched point?
bool Verdict::reaches(const Place& place, double tolerance) const {
  const bool u = has(place, vertices_[0]), v = has(place, vertices_[1]), w = has(place, vertices_[2]);
  if (u && v && w) return true;  // it has all of the feature
  const auto& [a, b, c] = place.corner;
  return (u || v || w) && in_box(first_->point, position(a), position(b), position(c), tolerance) &&
         norm(closest_point(first_->point, surface_.triangle(place)) - first_->point) <= tolerance;
}

/// The lowest number of the triangles around the touched feature that reach the touched point. As they reach
/// it, all of them were considered.
std::uint32_t Verdict::lowest_triangle() const {
  const double tolerance = first_->tolerance + rounding_of_distance * first_->point.cwiseAbs().maxCoeff();
  if (considered_.count == 1) return face_;
  std::uint32_t lowest = face_;
  const auto lower = [&](const Place* place) {
    if (place->number < lowest && reaches(*place, tolerance)) lowest = place->number;
  };
  std::for_each_n(considered_.first.begin(), considered_.count, lower);
  std::for_each(considered_.more.begin(), considered_.more.end(), lower);
  return lowest;
}

std::optional<Contact> Verdict::contact() const {
  if (!first_) return std::nullopt;
  return Contact{first_->time, only(first_->point), first_->normal, first_->feature, lowest_triangle()};
}

}  // namespace first_contact::bvh
