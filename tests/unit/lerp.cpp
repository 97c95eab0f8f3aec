#include <algorithm>
#include <utility>

#include "catch.hpp"
#include "first_contact/geometry/space.hpp"

using first_contact::lerp;

TEST_CASE(
    "Half way between two numbers is their mean, at the ends are the numbers, and beyond it goes on evenly") {
  for (const auto& [a, b] :
       {std::pair(1.0, 3.0), std::pair(3.0, 1.0), std::pair(-1.0, -5.0), std::pair(-2.0, 2.0)}) {
    CAPTURE(a, b);
    CHECK(lerp(a, b, 0) == a);
    CHECK(lerp(a, b, 1) == b);
    for (const double t : {-1.5, -0.25, 0.25, 0.5, 1.25, 1.5, 2.0, 3.5})
      CHECK(lerp(a, b, t) == a + t * (b - a));
  }
}

TEST_CASE(
    "On the way between two numbers none is behind the end, and beyond it none is before, whatever is "
    "rounded") {
  for (double a = 0.1; a < 1e3; a *= 1.7)
    for (double b = 0.3; b < 1e3; b *= 1.9) {
      const double step = 0x1p-52, low = std::min(a, b), high = std::max(a, b);
      const double before = lerp(a, b, 1 - step / 2), after = lerp(a, b, 1 + step);
      CHECK((before >= low && before <= high));
      CHECK((b > a ? after >= b : after <= b));
    }
}
