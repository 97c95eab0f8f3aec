#include <algorithm>
#include <cmath>

#include "figures.hpp"
#include "first_contact/figure/framing.hpp"
#include "first_contact/geometry/transform.hpp"
#include "parts.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

namespace {

// Two directions that span the plane, the first along the motion where it has one.
std::pair<Vector, Vector> directions_in(const Plane& plane, const Vector& motion) {
  const Vector n = plane.normal();
  const Vector flat = motion - motion.dot(n) * n;
  const Vector u = flat.norm() > 1e-3 * motion.norm() ? Vector(flat.normalized()) : n.unitOrthogonal();
  return {u, n.cross(u)};
}

// A flat box as thick as a line, so that it has sides to draw.
Box thickened(Box box) {
  const auto thicken = [](Vector& axis, const Vector& a, const Vector& b) {
    if (!axis.isZero(0)) return;
    const Vector across = a.cross(b);
    const Vector along = a.isZero(0) ? b : a;
    if (!across.isZero(0))
      axis = 0.006 * across.normalized();
    else
      axis = 0.006 * (along.isZero(0) ? Vector(Vector::UnitX()) : along.unitOrthogonal());
  };
  for (Vector* axis : {&box.r, &box.s, &box.t})
    if (axis->norm() < 1e-6) axis->setZero();
  thicken(box.r, box.s, box.t);
  thicken(box.s, box.t, box.r);
  thicken(box.t, box.r, box.s);
  return box;
}

// The scene near the origin, and about as large as 1.
struct Drawable {
  Moving<Box> moving;
  Plane plane;
  std::optional<Contact> contact;
};

Drawable drawable(const Plane& plane, const Moving<Box>& moving, std::optional<Contact> contact) {
  const auto& [box, v] = moving;
  const Point origin = on(plane, box.center);
  const Vector height = box.center - origin;
  const Framing framing = Framing::about(origin, {box.r, box.s, box.t, v, height});
  const Box small{framing.point(box.center), framing.length(box.r), framing.length(box.s),
                  framing.length(box.t)};
  if (contact) contact->points = (contact->points.colwise() - origin) / framing.unit;
  return {Moving{small, framing.length(v)}, Plane(plane.normal(), 0), contact};
}

// The letters of the sweep: centres, motion, normal, planes.
void name_parts(figure::Scene& scene, const Point& q0, const Point& end, bool contact) {
  scene.dot(q0);
  scene.dot(end);
  scene.label(contact ? "{/:Italic Q}({/:Italic t})" : "{/:Italic Q}_1", end, 1.9, 0.5);
  scene.label(contact ? "{/:Italic t}{/:Bold V}" : "{/:Bold V}", 0.5 * (q0 + end), 1.3, 0.8, colour::red);
}

void name_planes(figure::Scene& scene, const Point& corner, const Point& foot, const Vector& offset) {
  scene.arrow(foot, foot + offset, {colour::ink, 2.4});
  scene.label("{/:Bold N}", foot + offset, 1.6, -0.4);
  scene.label("{/:Italic E}", corner, 0.6, 0, colour::blue, Align::left);
  scene.label("{/:Italic E}′", corner + offset, 0.6, 0, colour::grey, Align::left);
}

void name_contact(figure::Scene& scene, const ContactPoints& points) {
  mark_contact(scene, points);
  for (Eigen::Index i = 0; i < points.cols(); ++i) scene.label(name_of(points, i), points.col(i), 0.2, -0.9);
}

}  // namespace

void draw_sweep(const Studio& studio, const Plane& any_plane, const Moving<Box>& any_box,
                const std::optional<Contact>& any_contact) {
  const Drawable drawn = drawable(any_plane, any_box, any_contact);
  const auto& [moving, plane, contact] = drawn;
  const Box& start = moving.shape;
  const Point q0 = start.center, q1 = q0 + moving.displacement;
  const Point end = q0 + (contact ? contact->time : 1.0) * moving.displacement;
  const Rigid shift = Rigid::moved_by(end - q0);
  const Vector n = std::copysign(1.0, plane.signed_distance(q0)) * plane.normal();
  const double radius = start.effective_radius(n);
  const auto [u, v] = directions_in(plane, moving.displacement);
  const double size = std::max({start.r.norm(), start.s.norm(), start.t.norm()});
  const double reach = std::max(0.2, 0.5 * (on(plane, q1) - on(plane, q0)).norm() + 0.9 * size);
  const Point middle = 0.5 * (on(plane, q0) + on(plane, q1));
  const Vector half_u = reach * u, half_v = 0.75 * reach * v;

  figure::Scene scene({72, 24});
  scene.patch(middle, half_u, half_v, plane_fill, -3);
  scene.polygon(shadow(start, plane), {colour::shadow, 0.6}, -2);
  scene.polygon(shadow(shift.box(start), plane), {colour::shadow}, -1);
  scene.patch(middle + radius * n, half_u, half_v, offset_fill, 1);
  scene.box(thickened(start), solid, 2);
  scene.box(shift.box(thickened(start)), glass);
  scene.arrow(q0, end, {colour::red, 2.4}, 3);
  if (contact && (q1 - end).norm() > 0.02 * moving.displacement.norm()) {
    scene.line({end, q1}, {colour::red, 1.4, true});
    scene.dot(q1);
    scene.label("{/:Italic Q}_1", q1, 1.3, -0.2);
  }
  name_planes(scene, middle + half_u + half_v, middle - 0.85 * half_u - 0.75 * half_v, radius * n);
  name_parts(scene, q0, end, contact.has_value());
  scene.label("{/:Italic Q}_0", q0 + radius * n, 0, 0.9);
  if (contact) name_contact(scene, contact->points);
  Figure figure(studio, "figure-05", scene.size());
  scene.draw(figure);
  figure.draw();
}
