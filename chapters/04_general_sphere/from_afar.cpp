#include "from_afar.hpp"

#include <cmath>

#include "first_contact/sweep/contact_times.hpp"

using namespace first_contact;

namespace general_sphere_chapter {

namespace {

//! [entered]
template <class Scalar>
Entered entered(const Vector& from, const Vector& way) {
  const Vector3<Scalar> m = from.cast<Scalar>(), v = way.cast<Scalar>();
  const Scalar a = squared_norm(v), b = dot(m, v), c = squared_norm(m) - 1;
  Entered found{static_cast<double>(-b), static_cast<double>(std::sqrt(b * b - a * c)), {}, {}};
  if (const auto times = textbook_times<Scalar>(m, v, 1)) found.textbook = static_cast<double>(times->begin);
  if (const auto times = contact_times<Scalar>(m, v, 1)) found.stable = static_cast<double>(times->begin);
  return found;
}
//! [entered]

}  // namespace

FromAfar from_afar(double distance, double beside) {
  const Point from(-distance, beside, 0);
  const Vector way(2 * distance, 0, 0);
  return {from, way, entered<float>(from, way), entered<double>(from, way)};
}

}  // namespace general_sphere_chapter
