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
std::optional<double> time_of_printed_cylinder(const Moving<Sphere>& moving, const Environment& environment,
                                               const MeshEdges::Edge& edge) {
  const auto sides = environment.topology().sides(edge);
  if (sides.size() != 2) return std::nullopt;
  const Vector n = environment.facet(sides[0].face).unit_normal(),
               m = environment.facet(sides[1].face).unit_normal();
  const Vector out = moving.shape.radius / (1 + n.dot(m)) * (n + m);  // to where both moved-out faces meet
  if (!out.allFinite()) return std::nullopt;  // faces folded onto each other: they meet nowhere
  const auto& vertices = environment.mesh().vertices();
  const Point a = vertices[edge.vertices[0]] + out, b = vertices[edge.vertices[1]] + out;
  const auto contact = sweep(moving, Triangle{a, b, b});  // a triangle without width is a segment
  return contact ? std::optional(contact->time) : std::nullopt;
}
//! [printed_cylinder]

std::optional<Contact> first_face_in_the_list(const Moving<Sphere>& moving, const Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.size(); ++i)
    if (const auto contact = sweep(moving, mesh.triangle(i)); contact && contact->feature == Feature::face)
      return contact;
  return std::nullopt;
}

}  // namespace general_sphere_chapter
