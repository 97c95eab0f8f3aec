#include "first_contact/bvh/build/merged.hpp"

#include <bit>
#include <limits>

namespace first_contact::bvh {

namespace {

/// A number that is the same for points in the same position, and rarely for others.
std::uint64_t hash(const Point& p) {
  std::uint64_t result = 0;
  for (const double x : p) {
    result ^= std::bit_cast<std::uint64_t>(x + 0.0);  // -0 is 0
    result *= 0x9e3779b97f4a7c15U;
    result ^= result >> 32;
  }
  return result;
}

}  // namespace

Merged::Merged(const Mesh& mesh) {
  constexpr std::uint32_t empty = std::numeric_limits<std::uint32_t>::max();
  const auto& vertices = mesh.vertices();
  const std::size_t mask = std::bit_ceil(2 * vertices.size() + 1) - 1;
  std::vector<std::uint32_t> table(mask + 1, empty), lowest(vertices.size());
  bool merged = false;
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    std::size_t slot = hash(vertices[i]) & mask;
    while (table[slot] != empty && vertices[table[slot]] != vertices[i]) slot = (slot + 1) & mask;
    if (table[slot] == empty) table[slot] = i;
    lowest[i] = table[slot];
    merged |= lowest[i] != i;
  }
  if (merged) representative_ = std::move(lowest);
}

}  // namespace first_contact::bvh
