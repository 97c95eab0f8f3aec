#include "first_contact/geometry/triangle_distance.hpp"

#include <algorithm>
#include <array>

#include "first_contact/geometry/closest_point.hpp"
#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/unit_scale.hpp"

namespace first_contact {
namespace {

void keep_nearer(NearestPoints& best, const NearestPoints& offer) {
  if (squared_norm(offer.second - offer.first) < squared_norm(best.second - best.first)) best = offer;
}

NearestPoints turned_round(const NearestPoints& pair) { return {pair.second, pair.first}; }

// A corner of one against the face of the other, and an edge of one that pierces the face of the other.
void offer_face(NearestPoints& best, const std::array<Point, 3>& corners, const Triangle& face,
                bool swapped) {
  const Vector n = face.area_vector();
  for (std::size_t i = 0; i < 3; ++i) {
    const Point &p = corners[i], &q = corners[(i + 1) % 3];
    const auto offer = [&](const Point& point) {
      const NearestPoints pair{point, closest_point(point, face)};
      keep_nearer(best, swapped ? turned_round(pair) : pair);
    };
    offer(p);
    const double above = dot(n, p - face.a), below = dot(n, q - face.a);
    if ((above > 0) != (below > 0) && above != below) offer(p + above / (above - below) * (q - p));
  }
}

// The same question in a unit in which all six points, as seen from the first, are of ordinary size.
template <class Ask>
NearestPoints in_unit(double unit, const Ask& ask) {
  const NearestPoints pair = ask(unit);
  return {pair.first / unit, pair.second / unit};
}

double unit_of(double size, const Point& at) {
  const double unit = is_ordinary(size) ? 1 : unit_scale(size, largest(at));
  return is_ordinary(unit * size) ? unit : 1;
}

}  // namespace

double NearestPoints::distance() const { return norm(second - first); }

//! [nearest_of_segments]
NearestPoints nearest_points(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (const double unit = unit_of(largest(b - a, c - a, d - a), a); unit != 1)
    return in_unit(unit, [&](double s) { return nearest_points(s * a, s * b, s * c, s * d); });
  NearestPoints best{a, closest_point(a, c, d)};
  keep_nearer(best, {b, closest_point(b, c, d)});
  keep_nearer(best, {closest_point(c, a, b), c});
  keep_nearer(best, {closest_point(d, a, b), d});
  const Vector u = b - a, v = d - c, across = u.cross(v);
  if (across.isZero(0)) return best;  // parallel: an end is nearest
  const Point p = a + std::clamp(dot((c - a).cross(v), across) / squared_norm(across), 0.0, 1.0) * u;
  keep_nearer(best, {p, closest_point(p, c, d)});
  return best;
}
//! [nearest_of_segments]

//! [nearest_of_triangles]
NearestPoints nearest_points(const Triangle& first, const Triangle& second) {
  const Point& a = first.a;
  const double size =
      std::max(largest(first.b - a, first.c - a, second.a - a), largest(second.b - a, second.c - a, a - a));
  if (const double unit = unit_of(size, a); unit != 1)
    return in_unit(unit, [&](double s) {
      return nearest_points({s * a, s * first.b, s * first.c}, {s * second.a, s * second.b, s * second.c});
    });
  const std::array<Point, 3> p{first.a, first.b, first.c}, q{second.a, second.b, second.c};
  NearestPoints best{p[0], q[0]};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      keep_nearer(best, nearest_points(p[i], p[(i + 1) % 3], q[j], q[(j + 1) % 3]));
  offer_face(best, p, second, false);
  offer_face(best, q, first, true);
  return best;
}
//! [nearest_of_triangles]

}  // namespace first_contact
