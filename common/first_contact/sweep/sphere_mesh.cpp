#include "first_contact/sweep/sphere_mesh.hpp"

#include <algorithm>
#include <tuple>
#include <vector>

#include "first_contact/geometry/closest_point.hpp"
#include "first_contact/sweep/moved_out.hpp"
#include "first_contact/sweep/nearest.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"

namespace first_contact {

namespace {

/// A search for the first contact of one sphere among the features of an environment, in whatever order they
/// come.
class FirstTouch {
 public:
  FirstTouch(const Moving<Sphere>& sphere, const Environment& surface)
      : moving_(sphere), environment_(surface) {}

  void face(std::size_t number);
  void edge(std::size_t number);
  void vertex(std::uint32_t number);
  std::optional<Contact> contact() const;

 private:
  using Vertices = std::array<std::uint32_t, 3>;

  bool too_late(const std::optional<Touch>& touch) const {
    return !touch || (first_ && touch->time > first_->time);
  }
  void keep(const Touch& touch, const Vertices& vertices, std::size_t triangle);
  const Point& position(std::uint32_t vertex) const { return environment_.mesh().vertices()[vertex]; }
  bool speaks_for_itself(const MeshEdges::Edge& edge) const;
  std::size_t lowest_triangle() const;

  const Moving<Sphere>& moving_;
  const Environment& environment_;
  std::optional<Touch> first_;
  Vertices vertices_{};                 // of the feature that is touched first, some of them twice
  std::size_t triangle_ = no_triangle;  // one that has this feature
};

/// Where triangles overlap in one plane, two of them may be touched all alike: then the lower number wins.
void FirstTouch::keep(const Touch& touch, const Vertices& vertices, std::size_t triangle) {
  if (first_ && !earlier(touch, *first_)) {
    const bool alike = !earlier(*first_, touch);
    if (!alike || std::tie(triangle, vertices) >= std::tie(triangle_, vertices_)) return;
  }
  first_ = touch;
  vertices_ = vertices;
  triangle_ = triangle;
}

void FirstTouch::face(std::size_t number) {
  const Mesh::Face& corners = environment_.mesh().faces()[number];
  const auto merged = [&](std::uint32_t vertex) { return environment_.topology().representative(vertex); };
  if (const auto touch = touch_face(moving_, environment_.facet(number)))
    keep(*touch, {merged(corners[0]), merged(corners[1]), merged(corners[2])}, number);
}

/// Where the surface goes straight on, an edge is but a seam of its faces, unless they are too thin to answer
/// for it.
bool FirstTouch::speaks_for_itself(const MeshEdges::Edge& edge) const {
  const auto sides = environment_.topology().sides(edge);
  return edge.kind != EdgeKind::flat ||
         std::any_of(sides.begin(), sides.end(), [&](const MeshEdges::Side& side) {
           return environment_.facet(side.face).thin_for(moving_.shape.radius);
         });
}

//! [first_touch_edge]
void FirstTouch::edge(std::size_t number) {
  const MeshEdges::Edge& edge = environment_.topology().edges()[number];
  const auto& [from, to] = edge.vertices;
  const auto touch = touch_edge(moving_, position(from), position(to));
  if (too_late(touch)) return;

  std::vector<FaceAround> faces;
  for (const auto& [face, slot] : environment_.topology().sides(edge)) {
    const Facet& facet = environment_.facet(face);
    const std::array<Point, 3> corners{facet.triangle.a, facet.triangle.b, facet.triangle.c};
    faces.push_back({&facet, facet.normal.cross(corners[(slot + 1) % 3] - corners[slot])});
  }
  const auto judged = among_faces(*touch, faces, moving_);
  if (!judged || (judged->feature == Feature::edge && !speaks_for_itself(edge))) return;
  keep(*judged, {from, to, to}, environment_.topology().sides(edge)[0].face);
}
//! [first_touch_edge]

//! [first_touch_vertex]
void FirstTouch::vertex(std::uint32_t number) {
  const MeshEdges& topology = environment_.topology();
  if (topology.faces_at(number).empty()) return;
  const auto touch = touch_vertex(moving_, position(number));
  if (too_late(touch)) return;

  std::vector<Vector> edges;
  for (const std::uint32_t edge : topology.edges_at(number)) {
    const auto& [from, to] = topology.edges()[edge].vertices;
    edges.push_back(position(from == number ? to : from) - position(number));
  }
  std::vector<FaceAround> faces;
  for (const std::uint32_t face : topology.faces_at(number))
    faces.push_back({&environment_.facet(face), Vector::Zero()});
  const auto judged = among_edges(*touch, edges, faces, moving_);
  if (!judged || (judged->feature == Feature::vertex && topology.buried(number))) return;
  keep(*judged, {number, number, number}, topology.faces_at(number)[0]);
}
//! [first_touch_vertex]

/// The lowest number of the triangles around the touched feature that reach the touched point.
std::size_t FirstTouch::lowest_triangle() const {
  const double rounding = rounding_of_distance * first_->point.cwiseAbs().maxCoeff();
  const double tolerance = first_->tolerance + rounding;
  std::size_t lowest = triangle_;
  for (const std::uint32_t vertex : vertices_)
    for (const std::uint32_t face : environment_.topology().faces_at(vertex)) {
      if (face >= lowest) break;
      const Triangle& triangle = environment_.facet(face).triangle;
      if (norm(closest_point(first_->point, triangle) - first_->point) <= tolerance) lowest = face;
    }
  return lowest;
}

std::optional<Contact> FirstTouch::contact() const {
  if (!first_) return std::nullopt;
  return Contact{first_->time, only(first_->point), first_->normal, first_->feature, lowest_triangle()};
}

}  // namespace

bool overlap(const Sphere& sphere, const Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.size(); ++i)
    if (overlap(sphere, mesh.triangle(i))) return true;
  return false;
}

bool overlap(const Sphere& sphere, const Environment& environment) {
  return overlap(sphere, environment.mesh());
}

//! [sweep_sphere_mesh]
std::optional<Contact> sweep(const Moving<Sphere>& moving, const Environment& environment) {
  FirstTouch first(moving, environment);
  for (std::size_t i = 0; i < environment.mesh().size(); ++i) first.face(i);
  for (std::size_t i = 0; i < environment.topology().edges().size(); ++i) first.edge(i);
  for (std::uint32_t i = 0; i < environment.mesh().vertices().size(); ++i) first.vertex(i);
  return first.contact();
}
//! [sweep_sphere_mesh]

std::optional<Contact> sweep(const Moving<Sphere>& moving, const Mesh& mesh) {
  return sweep(moving, Environment(mesh));
}

}  // namespace first_contact
