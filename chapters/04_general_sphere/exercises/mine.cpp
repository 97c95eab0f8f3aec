// stands for: first_contact/sweep/first_root.cpp
// The student's exercise 4a under every edge and every vertex: ./course run general_sphere --mine
#include "workbook/mine.hpp"

#include "first_contact/sweep/first_root.hpp"

namespace mine {
#include "04_general_sphere/exercises/4a/answer.hpp"
}

namespace first_contact {

std::optional<Entry> first_root(const Vector& m, const Vector& v, double r, double) {
  if (m.squaredNorm() <= r * r) {
    if (m.dot(v) >= 0 && !m.isZero(0)) return std::nullopt;
    return Entry{0, normalized(m.isZero(0) ? Vector(-v) : m)};
  }
  const std::optional<double> t = mine::first_root(mine::vector(m), mine::vector(v), r);
  if (!t || *t > 1) return std::nullopt;
  return Entry{*t, normalized(r > 0 ? Vector(m + *t * v) : Vector(-v))};
}

}  // namespace first_contact
