#pragma once
#include "workbook/vectors.hpp"

/// Published mistakes that no exercise has, each in a few lines of our own: \see docs/museum.json. To be used
/// nowhere.
namespace workbook::museum {

//! [point_too_deep]
// The vertex is below the plane; its contact point is put a full depth below the vertex.
inline Point contact_point(const Plane& E, Point vertex) { return vertex + dot(E, vertex) * E.N; }
//! [point_too_deep]

//! [first_box_twice]
inline std::pair<double, double> interval(const Box& box, Vector axis) {
  const double reach =
      (std::abs(dot(box.R, axis)) + std::abs(dot(box.S, axis)) + std::abs(dot(box.T, axis))) / 2;
  return {dot(box.Q, axis) - reach, dot(box.Q, axis) + reach};
}
// The interval of the first box is taken twice, and compared with itself.
inline bool boxes_overlap(const Box& a, const Box& b) {
  for (const Vector& axis : {a.R, a.S, a.T, b.R, b.S, b.T}) {
    const auto [least_a, most_a] = interval(a, axis);
    const auto [least_b, most_b] = interval(a, axis);
    if (most_a < least_b || most_b < least_a) return false;
  }
  return true;
}
//! [first_box_twice]

//! [ghost]
// A ball rolls along a floor, a hair too low, and meets the seam of two tiles as if it were an edge that
// stands alone. The normal that comes out points backwards.
inline Vector normal_at_seam(Point centre, Vector way, double r, Point seam) {
  const double height = centre.z - seam.z, before = std::sqrt(r * r - height * height);
  const Point touching = {seam.x - std::copysign(before, way.x), seam.y, centre.z};
  return (touching - seam) / r;
}
//! [ghost]

//! [half_sunk]
// The point of the surface is taken for Q, where the centre should stand.
inline Point slide_end(const Plane& E, Point touched, Point wished) {
  return wished - dot(wished - touched, E.N) * E.N;
}
//! [half_sunk]

//! [zeno]
// Each flight takes e of the time of the one before it. All together they never come to `end`, if it is late.
inline int impacts_before(double end, double first_flight, double e, int patience) {
  int impacts = 0;
  for (double time = 0, flight = first_flight; time < end && impacts < patience; ++impacts)
    time += flight, flight *= e;
  return impacts;
}
//! [zeno]

//! [sticky]
// The velocity is turned in each frame in which the ball is found in the paddle, also on its way out.
inline double height_after(int frames, double height, double velocity, double paddle) {
  for (int i = 0; i < frames; ++i) {
    height += velocity;
    if (height < paddle) velocity = -velocity;
  }
  return height;
}
//! [sticky]

//! [stops_early]
// An elastic easing runs past 1 and comes back; the animation ends when the value is 1 for the first time.
inline double time_of_end(int frames) {
  const double third = 2 * std::acos(-1.0) / 3;
  for (int i = 0; i <= frames; ++i) {
    const double s = static_cast<double>(i) / frames;
    const double value = s == 0 ? 0 : 1 + std::pow(2, -10 * s) * std::sin((10 * s - 0.75) * third);
    if (value >= 1) return s;
  }
  return 1;
}
//! [stops_early]

}  // namespace workbook::museum
