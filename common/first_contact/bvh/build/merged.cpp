#include "first_contact/bvh/build/merged.hpp"

#include "first_contact/geometry/weld.hpp"

namespace first_contact::bvh {

Merged::Merged(const Mesh& mesh) {
  std::vector<std::uint32_t> lowest = welded(mesh.vertices());
  for (std::uint32_t i = 0; i < lowest.size(); ++i)
    if (lowest[i] != i) {
      representative_ = std::move(lowest);
      return;
    }
}

}  // namespace first_contact::bvh
