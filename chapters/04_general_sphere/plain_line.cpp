#include "plain_line.hpp"

#include "first_contact/geometry/line_triangle.hpp"
#include "first_contact/geometry/products.hpp"
#include "first_contact/program/random.hpp"

using namespace first_contact;

namespace general_sphere_chapter {

//! [plain_line]
bool plain_line_meets(const Vector& v, const Vector& a, const Vector& b, const Vector& c) {
  const double ab = dot(v, a.cross(b)), bc = dot(v, b.cross(c)), ca = dot(v, c.cross(a));
  return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}
//! [plain_line]

FarLines lines_from(double distance) {
  std::mt19937 random(4);
  FarLines count{1000, 0, 0};
  for (int i = 0; i < count.lines; ++i) {
    const Vector a = program::unit_vector(random), b = program::unit_vector(random),
                 c = program::unit_vector(random);
    const Point from = distance * program::unit_vector(random), target = 0.3 * a + 0.3 * b + 0.4 * c;
    const Vector v = target - from, p = a - from, q = b - from, r = c - from;
    count.missed += !plain_line_meets(v, p, q, r);
    count.missed_by_library += !weights_where_line_meets(v, p, q, r);
  }
  return count;
}

}  // namespace general_sphere_chapter
