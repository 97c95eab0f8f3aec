#include "first_contact/bvh/build/surface.hpp"

#include "first_contact/geometry/weld.hpp"

namespace first_contact::bvh {

namespace {

std::vector<Mesh::Face> welded_faces(const Mesh& mesh) {
  const std::vector<std::uint32_t> lowest = welded(mesh.vertices());
  std::vector<Mesh::Face> faces = mesh.faces();
  for (Mesh::Face& face : faces)
    for (std::uint32_t& vertex : face) vertex = lowest[vertex];
  return faces;
}

/// Adds each vertex of each face, once, with the face.
template <class Add>
void each_corner(const std::vector<Mesh::Face>& faces, const Add& add) {
  for (std::uint32_t i = 0; i < faces.size(); ++i) {
    const auto& [a, b, c] = faces[i];
    add(a, i);
    if (b != a) add(b, i);
    if (c != a && c != b) add(c, i);
  }
}

}  // namespace

Surface::Surface(const Mesh& mesh)
    : mesh_(mesh),
      corners_(welded_faces(mesh)),
      around_(mesh.vertices().size(), [&](const auto& add) { each_corner(corners_, add); }) {}

}  // namespace first_contact::bvh
