#include "first_contact/geometry/weld.hpp"

#include <bit>
#include <limits>

namespace first_contact {

namespace {

/// A number that is the same for points at the same position, and rarely for others.
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

// A table at most half full, in which each position has the place of its hash or the next that was free.
std::vector<std::uint32_t> welded(std::span<const Point> points) {
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  const std::size_t mask = std::bit_ceil(2 * points.size() + 1) - 1;
  std::vector<std::uint32_t> table(mask + 1, none), lowest(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    std::size_t slot = hash(points[i]) & mask;
    while (table[slot] != none && points[table[slot]] != points[i]) slot = (slot + 1) & mask;
    if (table[slot] == none) table[slot] = i;
    lowest[i] = table[slot];
  }
  return lowest;
}

}  // namespace first_contact
