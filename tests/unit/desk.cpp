#include "first_contact/batch/desk.hpp"

#include <array>
#include <vector>

#include "catch.hpp"

using namespace first_contact::batch;

namespace {

constexpr std::size_t page = 512;  // doubles

/// Fifteen columns, of which so many begin alike in a page, and all others each at a place of its own.
bool is_crowded(std::size_t alike) {
  static const std::vector<double> memory(32 * page);
  std::array<const double*, 15> column;
  for (std::size_t i = 0; i < column.size(); ++i)
    column[i] = memory.data() + i * page + (i < alike ? 0 : (i + 1) * line);
  const auto& c = column;
  const Spheres p{{c[0], c[2], c[4]}, c[6], {c[8], c[10], c[12]}},
      q{{c[1], c[3], c[5]}, c[7], {c[9], c[11], c[13]}};
  return crowded(p, q, c[14]);
}

}  // namespace

TEST_CASE("Columns drive each other out of the cache if more than eight begin at one place of a page") {
  for (const std::size_t alike : {1U, 7U, 8U}) CHECK_FALSE(is_crowded(alike));
  for (const std::size_t alike : {9U, 12U, 15U}) CHECK(is_crowded(alike));
}
