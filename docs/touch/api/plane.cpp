// Chapter 1: a moving sphere meets a plane, as the sweep finds it, as pictures show it, and as it is printed.
#include "01_plane/frames.hpp"
#include "page.hpp"

using namespace first_contact;
using touch::tell;

namespace {

void tell_contact(const Moving<Sphere>& ball, const Contact& contact) {
  tell("contact/time", contact.time);
  tell("contact/center", ball.shape.center + contact.time * ball.displacement);
  tell("contact/point", contact.point());
  tell("contact/normal", contact.normal);
}

void tell_frames(long count, const Moving<Sphere>& ball, const Plane& plane) {
  std::vector<double> centers;
  for (long i = 0; i <= count; ++i)
    for (const double coordinate : in_frame(i, count, ball).center) centers.push_back(coordinate);
  tell("drawn/centers", centers);
  if (const auto first = first_frame_of_overlap(count, ball, plane))
    tell("frames/first_overlap", double(*first));
}

}  // namespace

//! [touch_plane]
FOR_THE_PAGE(plane)
(double a, double b, double c, double d, double x0, double y0, double z0, double x1, double y1, double z1,
 double radius, double length, double frames) {
  const Plane plane{{a, b, c}, d};
  const Point from{x0, y0, z0}, to{x1, y1, z1};
  const Moving<Sphere> ball{{from, radius}, to - from};
  const double distance = plane.signed_distance(from), toward = plane.normal().dot(ball.displacement);
  tell("drawn/normal", plane.normal());
  tell("drawn/offset", plane.offset());
  tell("drawn/raised", std::copysign(radius, distance));
  tell("distance_start", distance);
  tell("distance_end", plane.signed_distance(to));
  tell("gap", distance - radius);
  tell("toward", toward);
  if (const auto contact = sweep(ball, plane)) tell_contact(ball, *contact);
  tell("scaled_time", (radius - length * distance) / (length * toward));
  tell_frames(long(frames), ball, plane);
}
//! [touch_plane]
