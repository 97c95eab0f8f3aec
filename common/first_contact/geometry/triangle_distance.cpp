#include "first_contact/geometry/triangle_distance.hpp"

#include <algorithm>
#include <array>

#include "first_contact/geometry/closest_point.hpp"
#include "first_contact/geometry/products.hpp"

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

}  // namespace

double NearestPoints::distance() const { return norm(second - first); }

//! [nearest_of_segments]
NearestPoints nearest_points(const Point& a, const Point& b, const Point& c, const Point& d) {
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
