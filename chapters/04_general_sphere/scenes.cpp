#include "scenes.hpp"

#include "first_contact/sweep/sphere_triangle.hpp"

using namespace first_contact;

namespace general_sphere_chapter {

Mesh cut_cube() {
  constexpr double h = 0.8, cut = 0.75;
  return {{{-h, -h, -h},
           {h, -h, -h},
           {h, h, -h},
           {-h, h, -h},
           {-h, -h, h},
           {h, h, h},
           {-h, h, h},
           {h - cut, -h, h},
           {h, -h + cut, h},
           {h, -h, h - cut}},
          {{0, 3, 2},
           {0, 2, 1},
           {0, 1, 9},
           {0, 9, 7},
           {0, 7, 4},
           {1, 2, 5},
           {1, 5, 8},
           {1, 8, 9},
           {2, 3, 6},
           {2, 6, 5},
           {3, 0, 4},
           {3, 4, 6},
           {4, 7, 6},
           {7, 8, 6},
           {8, 5, 6},
           {7, 9, 8}}};
}

std::vector<Vector2> section_of_prism() {
  return {{-1.6, -0.9}, {1.4, -0.9}, {1.4, 0.3}, {0.3, 1.1}, {-0.4, 0.4}, {-1.6, 0.6}};
}

Mesh prism() {
  const auto section = section_of_prism();
  const auto corners = static_cast<std::uint32_t>(section.size());
  std::vector<Point> vertices;
  std::vector<Mesh::Face> faces;
  for (const double y : {-3.0, 3.0})
    for (const Vector2& corner : section) vertices.emplace_back(corner.x(), y, corner.y());
  for (std::uint32_t i = 0; i < corners; ++i) {
    const std::uint32_t next = (i + 1) % corners;
    faces.push_back({next, i, i + corners});
    faces.push_back({next, i + corners, next + corners});
  }
  for (const Mesh::Face& end : {Mesh::Face{0, 4, 5}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}}) {
    faces.push_back(end);
    faces.push_back({end[2] + corners, end[1] + corners, end[0] + corners});
  }
  return {std::move(vertices), std::move(faces)};
}

Mesh step() {
  return {{{-2, -1, 0},
           {2, -1, 0},
           {2, 1, 0},
           {-2, 1, 0},
           {0, -1, 0},
           {0, 1, 0},
           {0, -1, 1},
           {0, 1, 1},
           {2, -1, 1},
           {2, 1, 1}},
          {{0, 1, 2}, {0, 2, 3}, {6, 8, 9}, {6, 9, 7}, {4, 6, 7}, {4, 7, 5}}};
}

//! [printed_cylinder]
std::optional<std::array<Point, 2>> printed_axis(const Environment& environment, const MeshEdges::Edge& edge,
                                                 double radius) {
  const auto sides = environment.topology().sides(edge);
  if (sides.size() != 2) return std::nullopt;
  const Vector n = environment.facet(sides[0].face).unit_normal(),
               m = environment.facet(sides[1].face).unit_normal();
  const Vector out = radius / (1 + n.dot(m)) * (n + m);  // to where both moved-out faces meet
  if (!out.allFinite()) return std::nullopt;             // faces folded onto each other: they meet nowhere
  const auto& vertices = environment.mesh().vertices();
  return std::array<Point, 2>{vertices[edge.vertices[0]] + out, vertices[edge.vertices[1]] + out};
}

std::optional<double> time_of_printed_cylinder(const Moving<Sphere>& moving, const Environment& environment,
                                               const MeshEdges::Edge& edge) {
  const auto axis = printed_axis(environment, edge, moving.shape.radius);
  if (!axis) return std::nullopt;
  const auto& [a, b] = *axis;
  const auto contact = sweep(moving, Triangle{a, b, b});  // a triangle without width is a segment
  return contact ? std::optional(contact->time) : std::nullopt;
}
//! [printed_cylinder]

std::optional<double> printed_time(const Moving<Sphere>& moving, const Environment& environment) {
  std::optional<double> first;
  for (const auto& edge : environment.topology().edges()) {
    if (edge.kind != EdgeKind::convex) continue;
    const auto t = time_of_printed_cylinder(moving, environment, edge);
    if (t && (!first || *t < *first)) first = t;
  }
  return first;
}

std::optional<Contact> first_face_in_the_list(const Moving<Sphere>& moving, const Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.size(); ++i)
    if (const auto contact = sweep(moving, mesh.triangle(i)); contact && contact->feature == Feature::face)
      return contact;
  return std::nullopt;
}

}  // namespace general_sphere_chapter
