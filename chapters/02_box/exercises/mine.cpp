// stands for: first_contact/sweep/box_plane.cpp
// The student's exercises 2a and 2b in the place of the library's: ./course run box --mine
#include "workbook/mine.hpp"

#include <cmath>

#include "first_contact/sweep/box_plane.hpp"
#include "first_contact/sweep/sphere_plane.hpp"

namespace mine {
namespace reach {
#include "02_box/exercises/2a/answer.hpp"
}
#undef EXERCISE_FUNCTION
namespace points {
#include "02_box/exercises/2b/answer.hpp"
}

workbook::Box box(const first_contact::Box& box) {
  return {vector(box.center), vector(box.r), vector(box.s), vector(box.t)};
}
}  // namespace mine

namespace first_contact {

bool overlap(const Box& box, const Plane& plane) {
  return std::abs(plane.signed_distance(box.center)) <=
         mine::reach::effective_radius(mine::box(box), mine::vector(plane.normal()));
}

ContactPoints lowest_vertices(const Box& box, const Vector& normal) {
  const auto lowest = mine::points::lowest_points(mine::box(box), mine::vector(normal));
  ContactPoints points = only(box.center);
  if (!lowest.empty()) points.resize(3, static_cast<Eigen::Index>(std::min<std::size_t>(lowest.size(), 4)));
  for (Eigen::Index i = 0; i < points.cols() && !lowest.empty(); ++i)
    points.col(i) = mine::vector(lowest[static_cast<std::size_t>(i)]);
  return points;
}

std::optional<Contact> sweep(const Moving<Box>& moving, const Plane& plane) {
  const Box& box = moving.shape;
  const double reach = mine::reach::effective_radius(mine::box(box), mine::vector(plane.normal()));
  std::optional<Contact> contact =
      sweep(Moving{Sphere{box.center, std::max(0.0, reach)}, moving.displacement}, plane);
  if (!contact) return std::nullopt;
  contact->points = lowest_vertices(box, contact->normal).colwise() + contact->time * moving.displacement;
  for (auto point : contact->points.colwise()) point -= plane.signed_distance(point) * plane.normal();
  const Eigen::Index n = contact->points.cols();
  contact->feature = n == 1 ? Feature::vertex : n == 2 ? Feature::edge : Feature::face;
  return contact;
}

}  // namespace first_contact
