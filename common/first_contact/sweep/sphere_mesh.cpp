#include "first_contact/sweep/sphere_mesh.hpp"

#include "first_contact/sweep/known_environment.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"

namespace first_contact {

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
  const KnownEnvironment known(environment);
  FirstTouch<KnownEnvironment> first(known, moving);
  const MeshEdges& topology = environment.topology();
  const auto faces = static_cast<std::uint32_t>(environment.mesh().size());
  const auto vertices = static_cast<std::uint32_t>(environment.mesh().vertices().size());
  for (std::uint32_t i = 0; i < faces; ++i) first.face(i, known.corners(i), environment.facet(i));
  for (const MeshEdges::Edge& edge : topology.edges()) first.edge(edge.vertices[0], edge.vertices[1]);
  for (std::uint32_t i = 0; i < vertices; ++i)
    if (!topology.faces_at(i).empty()) first.vertex(i);
  return first.contact();
}
//! [sweep_sphere_mesh]

}  // namespace first_contact
