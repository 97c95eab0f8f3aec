#include "first_contact/sweep/box_box.hpp"

#include "first_contact/sweep/separating_axes.hpp"

namespace first_contact {

bool overlap(const Box& a, const Box& b) { return overlap(Hull(a), Hull(b)); }

std::optional<Contact> sweep(const Moving<Box>& moving, const Box& obstacle) {
  return sweep_hull(Hull(moving.shape), moving.displacement, Hull(obstacle));
}

}  // namespace first_contact
