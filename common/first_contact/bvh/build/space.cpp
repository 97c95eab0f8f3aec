#include "first_contact/bvh/build/space.hpp"

#include <cmath>

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
  int exponent = 0;
  std::frexp(half, &exponent);  // half < 2^exponent
  if (half > 0) scale_ = std::ldexp(1.0, -exponent);
}

}  // namespace first_contact::bvh
