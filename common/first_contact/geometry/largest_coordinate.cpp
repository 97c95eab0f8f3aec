#include "first_contact/geometry/largest_coordinate.hpp"

#include <algorithm>

namespace first_contact {

double largest_coordinate(const Sphere& sphere) {
  return std::max(sphere.center.lpNorm<Eigen::Infinity>(), sphere.radius);
}

double largest_coordinate(const Box& box) {
  double largest = 0;
  for (const Point& vertex : box.vertices()) largest = std::max(largest, vertex.lpNorm<Eigen::Infinity>());
  return largest;
}

double largest_coordinate(const Triangle& triangle) {
  return std::max({triangle.a.lpNorm<Eigen::Infinity>(), triangle.b.lpNorm<Eigen::Infinity>(),
                   triangle.c.lpNorm<Eigen::Infinity>()});
}

}  // namespace first_contact
