#include "first_contact/trees/cast.hpp"

#include <tuple>

#include "first_contact/sweep/sphere_triangle.hpp"

namespace first_contact {

namespace {

bool before(const Contact& a, const Contact& b) {
  return std::tie(a.time, a.feature, a.triangle) < std::tie(b.time, b.feature, b.triangle);
}

}  // namespace

Cast::Cast(const Moving<Sphere>& ball, std::span<const Triangle> triangles, const Bounds& scene)
    : BallSearch(ball, scene), triangles_(triangles) {}

//! [first_of_all]
bool Cast::hit(std::size_t triangle) {
  std::optional<Contact> contact = sweep(ball(), triangles_[triangle]);
  if (!contact) return false;
  contact->triangle = triangle;
  if (first_ && !before(*contact, *first_)) return true;
  first_ = contact;
  forget_after(contact->time);
  return true;
}
//! [first_of_all]

}  // namespace first_contact
