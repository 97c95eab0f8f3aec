#include "first_contact/trees/box_search.hpp"

#include <algorithm>
#include <utility>

#include "first_contact/trees/ball_search.hpp"

namespace first_contact {

BoxSearch::BoxSearch(const Bounds& box, const Bounds& scene, std::function<bool(std::size_t)> test)
    : Search(std::move(test)),
      box_(box),
      margin_(search_margin * std::max(scene.largest_coordinate(), box.largest_coordinate())) {}

Sides BoxSearch::sides(const Plane& plane, const Passage& part) const {
  constexpr Passage never{1, 0};
  if (box_.empty()) return {never, never};
  const double effective_radius = 0.5 * box_.size().dot(plane.normal().cwiseAbs()) + margin_;
  const double distance = plane.signed_distance(box_.center());  // E.Q
  return {distance < -effective_radius ? never : part, distance > effective_radius ? never : part};
}

}  // namespace first_contact
