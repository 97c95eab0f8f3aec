#include "first_contact/motion/sweep_tween.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "first_contact/geometry/products.hpp"
#include "first_contact/motion/timing.hpp"

namespace first_contact {

namespace {

double largest_coordinate_of(const Tween& tween) {
  double largest = 0;
  for (const KeyFrame& key : tween.keys()) largest = std::max(largest, key.position.cwiseAbs().maxCoeff());
  for (const Leg& leg : tween.legs()) largest = std::max(largest, largest_coordinate(leg.curve()));
  return largest;
}

// Control points go along with a linear map of the curve.
Bezier bent(const Bezier& curve, const Bend& bend) {
  std::vector<Point> points;
  for (const Point& p : curve.control_points()) points.emplace_back(product(bend.linear, p) + bend.shift);
  return Bezier(std::move(points));
}

}  // namespace

std::optional<Contact> sweep(const Tween& tween, double radius, const SphereSweep& first_contact_of,
                             double largest_coordinate, const Interval& clock, const Bend& bend) {
  const double size = std::max({largest_coordinate, largest_coordinate_of(tween), radius});
  const double smallest = std::numeric_limits<double>::min();
  const CurveSweep sphere(radius, first_contact_of, std::max(tween_gap * size, smallest), size);
  for (std::size_t i = 0; i < tween.legs().size(); ++i) {
    const Leg& leg = tween.legs()[i];
    const Timing timing(tween.keys()[i].easing, tween.keys()[i].time, tween.keys()[i + 1].time);
    for (const OneWay& way : timing.ways(clock))
      for (const Stretch& stretch : leg.stretches(way.from_part, way.to_part))
        if (auto contact = sphere.along(bent(stretch.curve, bend), stretch.from, stretch.to)) {
          contact->time = timing.time_of(leg.part(contact->time), way);
          return contact;
        }
  }
  return std::nullopt;
}

}  // namespace first_contact
