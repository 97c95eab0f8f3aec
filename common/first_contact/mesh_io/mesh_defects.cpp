#include "first_contact/mesh_io/mesh_defects.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "first_contact/geometry/weld.hpp"

namespace first_contact {
namespace {

using Index = std::uint32_t;

bool is_degenerate(const Triangle& t) {
  const double sides = norm(t.b - t.a) * norm(t.c - t.a);
  return !(norm(t.area_vector()) > degenerate_tolerance * sides);
}

std::size_t count_non_manifold(const std::vector<Mesh::Face>& faces) {
  std::vector<std::pair<Index, Index>> sides;
  sides.reserve(3 * faces.size());
  for (const auto& [a, b, c] : faces)  // their corners are in order
    sides.insert(sides.end(), {{a, b}, {b, c}, {a, c}});
  std::sort(sides.begin(), sides.end());
  std::size_t count = 0;
  for (auto first = sides.begin(); first != sides.end();) {
    const auto last = std::find_if(first, sides.end(), [&](const auto& side) { return side != *first; });
    count += last - first >= 3;
    first = last;
  }
  return count;
}

}  // namespace

//! [diagnose]
MeshDefects diagnose(const Mesh& mesh) {
  const std::vector<Index> position = welded(mesh.vertices());
  MeshDefects defects;
  std::vector<Mesh::Face> sound;
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    auto [a, b, c] = mesh.faces()[i];
    Mesh::Face face{position[a], position[b], position[c]};
    std::sort(face.begin(), face.end());
    if (is_degenerate(mesh.triangle(i)))
      ++defects.degenerate;
    else
      sound.push_back(face);
  }
  std::sort(sound.begin(), sound.end());
  const auto end = std::unique(sound.begin(), sound.end());
  defects.duplicate = static_cast<std::size_t>(sound.end() - end);
  sound.erase(end, sound.end());
  defects.non_manifold = count_non_manifold(sound);
  return defects;
}
//! [diagnose]

}  // namespace first_contact
