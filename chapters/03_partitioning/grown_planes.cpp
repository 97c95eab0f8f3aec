#include "grown_planes.hpp"

#include <algorithm>
#include <cmath>

using namespace first_contact;

std::array<Plane, 2> Wedge::planes() const {
  const double c = std::cos(half_angle), s = std::sin(half_angle);
  return {Plane({c, 0, s}, 0), Plane({-c, 0, s}, 0)};
}

std::vector<Triangle> Wedge::faces() const {
  const Vector right(8 * std::sin(half_angle), 0, -8 * std::cos(half_angle)), left(-right.x(), 0, right.z());
  const Vector y(0, 8, 0);
  return {{-y, right, y}, {-y, y, left}};
}

//! [time_at_grown_planes]
std::optional<double> time_at_grown_planes(const Moving<Sphere>& ball, const Wedge& wedge) {
  double enter = 0, leave = 1;
  for (const Plane& face : wedge.planes()) {
    const Plane grown = face.moved_out(ball.shape.radius);
    const double distance = grown.signed_distance(ball.shape.center);
    const double approach = grown.normal().dot(ball.displacement);
    if (approach == 0 && distance > 0) return std::nullopt;
    if (approach < 0) enter = std::max(enter, -distance / approach);
    if (approach > 0) leave = std::min(leave, -distance / approach);
  }
  if (enter > leave) return std::nullopt;
  return enter;
}
//! [time_at_grown_planes]
