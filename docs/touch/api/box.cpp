// Chapter 2: a box that is turned above a level floor: how far it reaches, and with what it lands.
#include "first_contact/sweep/box_plane.hpp"
#include "page.hpp"

using namespace first_contact;
using touch::tell;

namespace {

void tell_vertices(const char* name, const Box& box) {
  std::vector<double> numbers;
  for (const Point& vertex : box.vertices())
    numbers.insert(numbers.end(), {vertex.x(), vertex.y(), vertex.z()});
  tell(name, numbers);
}

void tell_contact(const Moving<Box>& moving, const Contact& contact) {
  const Vector way = contact.time * moving.displacement;
  const Box& box = moving.shape;
  tell("contact/time", contact.time);
  tell("contact/center", box.center + way);
  tell("contact/feature", to_string(contact.feature));
  for (Eigen::Index i = 0; i < contact.points.cols(); ++i)
    tell("contact/points/" + std::to_string(i), Vector(contact.points.col(i)));
  tell_vertices("drawn/landed", Box{box.center + way, box.r, box.s, box.t});
}

}  // namespace

FOR_THE_PAGE(box)
(double x0, double z0, double x1, double z1, double rx, double ry, double rz, double sx, double sy, double sz,
 double tx, double ty, double tz) {
  const Plane floor{{0, 0, 1}, 0};
  const Point from{x0, 0, z0}, to{x1, 0, z1};
  const Moving<Box> moving{{from, {rx, ry, rz}, {sx, sy, sz}, {tx, ty, tz}}, to - from};
  const Box& box = moving.shape;
  const Vector n = floor.normal();
  tell("effective_radius", box.effective_radius(n));
  tell("climbs", Vector(box.r.dot(n), box.s.dot(n), box.t.dot(n)));
  tell_vertices("drawn/box", box);
  if (const auto contact = sweep(moving, floor)) tell_contact(moving, *contact);
}
