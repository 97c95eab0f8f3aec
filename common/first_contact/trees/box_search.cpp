#include "first_contact/trees/box_search.hpp"

#include <algorithm>

#include "first_contact/geometry/products.hpp"
#include "first_contact/trees/ball_search.hpp"

namespace first_contact {

BoxSearch::BoxSearch(const Bounds& box, const Bounds& scene)
    : box_(box), margin_(search_margin * std::max(largest_coordinate(scene), largest_coordinate(box))) {}

Sides BoxSearch::sides(const Plane& plane, const Passage& part) const {
  constexpr Passage never{1, 0};
  if (box_.isEmpty()) return {never, never};
  const double effective_radius = 0.5 * dot(box_.sizes(), plane.normal().cwiseAbs()) + margin_;
  const double distance = plane.signed_distance(middle_of(box_));  // E.Q
  return {distance < -effective_radius ? never : part, distance > effective_radius ? never : part};
}

}  // namespace first_contact
