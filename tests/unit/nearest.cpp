#include "first_contact/sweep/nearest.hpp"

#include <array>
#include <cmath>

#include "catch.hpp"

using namespace first_contact;

namespace {

/// Is a touch below a ball kept, whose face rises along x by a slope? All lengths are in a unit.
bool is_kept(double slope, double unit) {
  const double radius = 0.95 * unit, tolerance = rounding_of_distance * radius;
  const Vector inward(unit, 0, slope * unit);
  const Facet face(Triangle({0, 0, 0}, inward, {0, unit, 0}));
  const Touch touch{0.5, radius, {0, 0, 1}, {0, 0, 0}, Feature::edge, tolerance};
  const Moving<Sphere> falling{{{0, 0, 1.5 * unit}, radius}, {0, 0, -unit}};
  return among_faces(touch, std::array{FaceAround{&face, inward}}, falling).has_value();
}

}  // namespace

TEST_CASE(
    "A face that rises no more than rounding hides no edge, in any unit: up to the root of twice the "
    "rounding") {
  const double noticed = std::sqrt(2 * rounding_of_distance);
  for (const double unit : {1.0, 0x1p-300, 0x1p300, 0x1p-470, 0x1p470, 0x1p-900, 0x1p900}) {
    CAPTURE(unit);
    for (const double part : {0.0, 0.5, 0.9}) CHECK(is_kept(part * noticed, unit));
    for (const double part : {1.1, 2.0, 1e3}) CHECK_FALSE(is_kept(part * noticed, unit));
  }
}
