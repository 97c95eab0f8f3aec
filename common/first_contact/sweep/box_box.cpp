#include "first_contact/sweep/box_box.hpp"

#include "first_contact/sweep/separating_axes.hpp"

namespace first_contact {

bool overlap(const Box& a, const Box& b) {
  return overlap(seen_from(b.center - a.center, about_origin(a)), about_origin(b));
}

std::optional<Contact> sweep(const Moving<Box>& moving, const Box& obstacle) {
  const Hull hull = seen_from(obstacle.center - moving.shape.center, about_origin(moving.shape));
  auto contact = sweep_hull(hull, moving.displacement, about_origin(obstacle));
  if (contact) contact->points.colwise() += obstacle.center;
  return contact;
}

}  // namespace first_contact
