#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

#include "first_contact/geometry/closest_point.hpp"
#include "first_contact/geometry/mesh_edges.hpp"
#include "first_contact/geometry/products.hpp"
#include "first_contact/sweep/nearest.hpp"

/// \file
/// Which feature of a surface does a moving sphere touch first, and what does it touch there? One algorithm
/// for every way to know what lies around a feature: an Environment knows it beforehand, a fast tree looks it
/// up when it must.

namespace first_contact {

/// A face, its corners by the numbers that its surface has for them, each position one number.
struct FaceAt {
  std::uint32_t number;                  ///< its place in the mesh
  std::array<std::uint32_t, 3> corners;  ///< in its own order
  Facet facet;                           ///< the face itself

  /// Is it a corner?
  bool has(std::uint32_t vertex) const {
    return corners[0] == vertex || corners[1] == vertex || corners[2] == vertex;
  }
};

/// Where the faces around a touched edge or vertex lead. If all lead away from the sphere, by much more than
/// rounding, the touch is what it seems; if one leads nearer, something else is touched before; or else it
/// has to be asked face by face.
enum class Lead { away, nearer, in_doubt };

/// What the faces around a touched edge or vertex say of it.
struct FacesAround {
  Lead lead;             ///< where they lead
  std::uint32_t lowest;  ///< if all lead away, the lowest of their numbers
};

/// A search for the first touch of one sphere among the features of a surface, in whatever order they come.
///
/// Known is what is known of the surface:
/// - `position(v)` of a vertex, which goes by the lowest number that the mesh has for it;
/// - `around(touch, from, to)`: where the faces around an edge, or a vertex (from = to), lead;
/// - `faces_at(from, to)`, all faces with both, lowest number first;
/// - `each_near(vertices, visit)`: calls visit(number, corners) for all faces with one of the vertices that
///   the sphere may touch.
template <class Known>
class FirstTouch {
 public:
  /// Both must outlive it.
  FirstTouch(const Known& surface, const Moving<Sphere>& sphere) : known_(surface), moving_(sphere) {}

  ///@{
  /// Considers a feature, by the numbers of its vertices.
  void face(std::uint32_t number, const std::array<std::uint32_t, 3>& corners, const Facet& facet,
            bool surely_within = false) {
    if (const auto touch = touch_face(moving_, facet, surely_within)) keep(*touch, corners, number);
  }
  void edge(std::uint32_t p, std::uint32_t q);
  void vertex(std::uint32_t vertex);
  ///@}

  /// The time of the first contact so far; 2 if there is none.
  double latest() const { return first_ ? first_->time : 2; }
  /// Begins once more, as if nothing had been considered.
  void forget() { first_.reset(); }
  /// The first contact of all that was considered.
  std::optional<Contact> contact() const {
    if (!first_) return std::nullopt;
    return Contact{first_->time, only(first_->point), first_->normal, first_->feature, lowest_triangle()};
  }

 private:
  using Vertices = std::array<std::uint32_t, 3>;

  bool too_late(const std::optional<Touch>& touch) const { return !touch || touch->time > latest(); }
  void keep(const Touch& touch, const Vertices& vertices, std::uint32_t face);
  std::uint32_t lowest_triangle() const;
  bool reaches(const Vertices& corners, double tolerance) const;

  const Known& known_;
  const Moving<Sphere>& moving_;
  std::optional<Touch> first_;
  Vertices vertices_{};     // of the feature that is touched first, some of them twice
  std::uint32_t face_ = 0;  // one that has this feature
};

/// The sides of some faces at one edge: as vectors, and the directions in which the faces leave it.
struct SidesAtEdge {
  std::vector<FaceAround> faces;  ///< those that have the edge
  std::vector<Vector> along;      ///< the edge as each of them goes along it

  /// Those of `all` that have the edge.
  SidesAtEdge(const std::vector<FaceAt>& all, std::uint32_t from, std::uint32_t to) {
    for (const FaceAt& face : all) {
      const std::array<Point, 3> at{face.facet.triangle.a, face.facet.triangle.b, face.facet.triangle.c};
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t p = face.corners[i], q = face.corners[(i + 1) % 3];
        if (!((p == from && q == to) || (p == to && q == from))) continue;
        along.emplace_back(at[(i + 1) % 3] - at[i]);
        faces.push_back({&face.facet, face.facet.normal.cross(along.back())});
      }
    }
  }
  /// Does the surface go straight on from one face to the other, so that their edge is but a seam? Not if one
  /// is too thin to answer for it.
  bool are_a_seam(double radius) const {
    if (faces.size() != 2 || faces[0].facet->thin_for(radius) || faces[1].facet->thin_for(radius))
      return false;
    const bool opposed = dot(along[0], along[1]) < 0;
    return kind_of(*faces[0].facet, *faces[1].facet, along[0], opposed) == EdgeKind::flat;
  }
};

//! [first_touch_edge]
template <class Known>
void FirstTouch<Known>::edge(std::uint32_t p, std::uint32_t q) {
  const bool turned = comes_before(known_.position(q), known_.position(p));
  const std::uint32_t from = turned ? q : p, to = turned ? p : q;
  const auto touch = touch_edge(moving_, known_.position(from), known_.position(to));
  if (too_late(touch)) return;
  const Vertices vertices{from, to, to};
  const auto [lead, lowest] = known_.around(*touch, from, to);
  if (lead == Lead::nearer) return;
  if (lead == Lead::away) return keep(*touch, vertices, lowest);

  const std::vector<FaceAt> around = known_.faces_at(from, to);
  const SidesAtEdge sides(around, from, to);
  const auto judged = among_faces(*touch, sides.faces, moving_);
  if (!judged || (judged->feature == Feature::edge && sides.are_a_seam(moving_.shape.radius))) return;
  keep(*judged, vertices, around[0].number);
}
//! [first_touch_edge]

//! [first_touch_vertex]
template <class Known>
void FirstTouch<Known>::vertex(std::uint32_t vertex) {
  const auto touch = touch_vertex(moving_, known_.position(vertex));
  if (too_late(touch)) return;
  const Vertices vertices{vertex, vertex, vertex};
  const auto [lead, lowest] = known_.around(*touch, vertex, vertex);
  if (lead == Lead::nearer) return;
  if (lead == Lead::away) return keep(*touch, vertices, lowest);

  const std::vector<FaceAt> around = known_.faces_at(vertex, vertex);
  std::vector<std::uint32_t> others;
  std::vector<FaceAround> faces;
  for (const FaceAt& face : around) {
    for (const std::uint32_t corner : face.corners)
      if (corner != vertex) others.push_back(corner);
    faces.push_back({&face.facet, Vector::Zero()});
  }
  std::sort(others.begin(), others.end());
  others.erase(std::unique(others.begin(), others.end()), others.end());
  std::vector<Vector> edges, directions;
  for (const std::uint32_t other : others) {
    edges.emplace_back(known_.position(other) - known_.position(vertex));
    directions.emplace_back(normalized(edges.back()));
  }
  const auto judged = among_edges(*touch, edges, faces, moving_);
  if (!judged || (judged->feature == Feature::vertex && !edges.empty() && buried_by(directions))) return;
  keep(*judged, vertices, around[0].number);
}
//! [first_touch_vertex]

/// Where triangles overlap in one plane, two of them may be touched all alike: then the lower number wins, and
/// then that of the vertices.
template <class Known>
void FirstTouch<Known>::keep(const Touch& touch, const Vertices& vertices, std::uint32_t face) {
  if (first_ && !earlier(touch, *first_)) {
    const bool alike = !earlier(*first_, touch);
    if (!alike || std::tie(face, vertices) >= std::tie(face_, vertices_)) return;
  }
  first_ = touch;
  vertices_ = vertices;
  face_ = face;
}

/// Does a face at one of the touched feature's vertices reach the touched point? That the point is in its box
/// is asked first: it is much quicker than the nearest point.
template <class Known>
bool FirstTouch<Known>::reaches(const Vertices& corners, double tolerance) const {
  const auto has = [&](std::uint32_t v) {
    return std::find(corners.begin(), corners.end(), v) != corners.end();
  };
  const bool u = has(vertices_[0]), v = has(vertices_[1]), w = has(vertices_[2]);
  if (u && v && w) return true;  // it has all of the feature
  if (!u && !v && !w) return false;
  const Point &a = known_.position(corners[0]), &b = known_.position(corners[1]),
              &c = known_.position(corners[2]), &p = first_->point;
  const Vector low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
  return (p.array() >= low.array() - tolerance).all() && (p.array() <= high.array() + tolerance).all() &&
         norm(closest_point(p, Triangle(a, b, c)) - p) <= tolerance;
}

/// The lowest number of the triangles around the touched feature that reach the touched point.
template <class Known>
std::uint32_t FirstTouch<Known>::lowest_triangle() const {
  const double tolerance = first_->tolerance + rounding_of_distance * first_->point.cwiseAbs().maxCoeff();
  std::uint32_t lowest = face_;
  known_.each_near(vertices_, [&](std::uint32_t number, const Vertices& corners) {
    if (number < lowest && reaches(corners, tolerance)) lowest = number;
  });
  return lowest;
}

}  // namespace first_contact
