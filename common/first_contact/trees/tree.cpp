#include "first_contact/trees/tree.hpp"

#include <numeric>

namespace first_contact {

std::vector<std::uint32_t> all_in_order(std::size_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  return order;
}

std::vector<Bounds> bounds_of_each(std::span<const Triangle> polygons) {
  std::vector<Bounds> all;
  all.reserve(polygons.size());
  for (const Triangle& polygon : polygons) all.push_back(bounds_of(polygon));
  return all;
}

}  // namespace first_contact
