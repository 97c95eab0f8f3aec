#include "plain_vertices.hpp"

#include "first_contact/geometry/products.hpp"

using namespace first_contact;

namespace box_chapter {

//! [plain_vertices]
std::vector<Point> plain_vertices(const Box& box, const Vector& normal) {
  std::vector<Point> points{box.center};
  for (const Vector& axis : {box.r, box.s, box.t}) {
    std::vector<Point> lower;
    for (const Point& p : points) {
      if (dot(axis, normal) >= 0) lower.push_back(p - 0.5 * axis);
      if (dot(axis, normal) <= 0) lower.push_back(p + 0.5 * axis);
    }
    points = lower;
  }
  return points;
}
//! [plain_vertices]

}  // namespace box_chapter
