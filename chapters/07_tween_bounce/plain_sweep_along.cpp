#include "plain_sweep_along.hpp"

#include <cmath>

#include "first_contact/sweep/sphere_plane.hpp"

using namespace first_contact;

namespace tween_bounce {

//! [plain_sweep_along]
std::optional<double> plain_sweep_along(const Curve& curve, double radius, const Plane& plane, int chords) {
  for (int i = 0; i < chords; ++i) {
    const double from = static_cast<double>(i) / chords, to = static_cast<double>(i + 1) / chords;
    const Point here = at(curve, from), there = at(curve, to);
    const auto contact = sweep(Moving<Sphere>{{here, radius}, there - here}, plane);
    if (contact) return std::lerp(from, to, contact->time);
  }
  return std::nullopt;
}
//! [plain_sweep_along]

}  // namespace tween_bounce
