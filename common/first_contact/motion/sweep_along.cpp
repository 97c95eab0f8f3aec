#include "first_contact/motion/sweep_along.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "first_contact/geometry/number_text.hpp"
#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/refuse.hpp"
#include "first_contact/response/slide.hpp"

namespace first_contact {

CurveSweep::CurveSweep(double radius, SphereSweep first_contact_of, double gap, double largest_coordinate)
    : radius_(radius),
      first_contact_of_(std::move(first_contact_of)),
      allowed_(gap / 2),
      rounding_(slide_gap * std::max(largest_coordinate, radius)) {
  require_length(radius, "radius");
  require_length(gap, "gap");
  const double size = std::max(largest_coordinate, radius);
  if (!(gap > 0) || gap < least_gap * size)
    refuse("gap", gap, "must be at least 2^-32 of the scene's size, " + to_text(size));
}

// Is anything within the gap of it? A sphere that overlaps something meets it at once if it moves against it, and
// one of four ways that point to the corners of a tetrahedron is against any normal.
bool CurveSweep::is_near(const Sphere& sphere) const {
  const double step = allowed_;
  const std::array<Vector, 4> ways{
      {{step, step, step}, {step, -step, -step}, {-step, step, -step}, {-step, -step, step}}};
  return std::any_of(ways.begin(), ways.end(), [&](const Vector& way) {
    return first_contact_of_({sphere, way}).has_value();
  });
}

// What goes along a wall goes into it by a rounding, or not: it is led along, so that the wall does not hide what
// is in front. Three walls hold it.
std::optional<Contact> CurveSweep::along_straight(const Moving<Sphere>& chord) const {
  Moving<Sphere> led = chord;
  std::optional<Contact> contact = first_contact_of_(led);
  for (int walls = 0; walls < 3 && contact && contact->time == 0; ++walls) {
    const double approach = -dot(contact->normal, led.displacement);
    if (!(approach <= rounding_)) break;
    led.displacement += (approach + rounding_) * contact->normal;
    contact = first_contact_of_(led);
  }
  return contact;
}

//! [look_along]
Glance CurveSweep::look_along(const Chord& chord) const {
  const double radius = std::min(radius_ + chord.deviation, largest_length);
  const Moving<Sphere> grown{{chord.from, radius}, chord.to - chord.from};
  if (chord.straight_enough) return {along_straight(grown), true};
  std::optional<Contact> contact = first_contact_of_(grown);
  const bool clear = !contact && !is_near(grown.shape);
  return {std::move(contact), clear};
}
//! [look_along]

std::optional<Contact> CurveSweep::along(const Bezier& curve, double begin, double end) const {
  return first_along(curve, begin, end, allowed_, [this](const Chord& chord) { return look_along(chord); });
}

std::optional<Contact> sweep_along(const Curve& curve, double radius, const SphereSweep& first_contact_of,
                                   double largest_coordinate, double gap) {
  const double size = std::max(largest_coordinate, first_contact::largest_coordinate(curve));
  const CurveSweep sphere(radius, first_contact_of, gap, size);
  const std::vector<Bezier> pieces = bezier_pieces(curve);
  const std::vector<double> joints = breaks(curve);
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (auto contact = sphere.along(pieces[i], joints[i], joints[i + 1])) return contact;
  return std::nullopt;
}

}  // namespace first_contact
