#include "first_contact/bvh/build/space.hpp"

#include "first_contact/geometry/unit_scale.hpp"

namespace first_contact::bvh {

Space::Space(const Mesh& mesh) {
  if (mesh.size() == 0) return;
  Point low = mesh.vertices()[mesh.faces()[0][0]], high = low;
  for (const Mesh::Face& face : mesh.faces())
    for (const std::uint32_t vertex : face) {
      low = low.cwiseMin(mesh.vertices()[vertex]);
      high = high.cwiseMax(mesh.vertices()[vertex]);
    }
  center_ = low / 2 + high / 2;
  const double half = (high / 2 - low / 2).maxCoeff();
  if (half > 0) scale_ = unit_scale(half);
}

}  // namespace first_contact::bvh
