#include <algorithm>
#include <cmath>

#include "figures.hpp"
#include "first_contact/figure/framing.hpp"
#include "parts.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

namespace {

// Two directions that span the plane, the first along the motion where it has one, and to the right in the
// picture; the second away from the eye.
std::pair<Vector, Vector> directions_in(const Plane& plane, const Vector& motion, const View& view) {
  const Vector n = plane.normal();
  const Vector flat = motion - motion.dot(n) * n;
  Vector u = flat.norm() > 1e-3 * motion.norm() ? Vector(flat.normalized()) : n.unitOrthogonal();
  if (u.dot(view.right()) < 0) u = -u;
  Vector v = n.cross(u);
  if (v.dot(view.eye()) > 0) v = -v;
  return {u, v};
}

// The scene of this run, as it can be drawn: near the origin, if it is not, and neither tiny nor huge.
struct Drawable {
  Plane plane;
  Moving<Sphere> ball;
  std::optional<Contact> contact;
};

Drawable drawable(const Plane& plane, const Moving<Sphere>& ball, std::optional<Contact> contact) {
  const auto& [s0, r] = ball.shape;
  const Vector height = plane.signed_distance(s0) * plane.normal();
  const Framing framing = Framing::if_needed(s0 - height, {height, ball.displacement, Vector::Constant(r)});
  if (contact) contact->points.col(0) = framing.point(contact->point());
  return {Plane(plane.normal(), framing.length(plane.signed_distance(framing.origin))),
          {{framing.point(s0), framing.length(r)}, framing.length(ball.displacement)},
          contact};
}

Point foot(const Plane& plane, const Point& p) { return p - plane.signed_distance(p) * plane.normal(); }

// Where the sweep of this run ends, and the piece of the plane that is drawn below it.
struct Stage {
  Point end;
  Vector n;  // toward the ball
  Point middle;
  Vector half_u, half_v;
};

Stage stage_of(const Drawable& drawn, const View& view) {
  const auto& [plane, ball, contact] = drawn;
  const auto& [s0, r] = ball.shape;
  const Vector n = std::copysign(1.0, plane.signed_distance(s0)) * plane.normal();
  const Point end = s0 + (contact ? contact->time : 1.0) * ball.displacement;
  const Point below_start = foot(plane, s0), below_end = foot(plane, end);
  const auto [u, v] = directions_in(plane, ball.displacement, view);
  const double reach =
      std::max(0.2, 0.5 * (below_end - below_start).norm() + 2.0 * r + 0.1 * ball.displacement.norm());
  return {end, n, 0.5 * (below_start + below_end), reach * u, 0.7 * reach * v};
}

}  // namespace

void draw_sweep(const Studio& studio, const Plane& any_plane, const Moving<Sphere>& any_ball,
                const std::optional<Contact>& any_contact) {
  const Drawable drawn = drawable(any_plane, any_ball, any_contact);
  const auto& [plane, ball, contact] = drawn;
  const auto& [s0, r] = ball.shape;
  const View view{70, 24};
  const auto [end, n, middle, half_u, half_v] = stage_of(drawn, view);

  figure::Scene scene(view);
  scene.patch(middle, half_u, half_v, {colour::floor, 1, false, plane_edge}, -3);
  scene.disc(foot(plane, s0), n, 0.85 * r, {colour::shadow, 0.6}, -2);
  scene.disc(foot(plane, end), n, 0.85 * r, {colour::shadow}, -1);
  scene.patch(middle + r * n, half_u, half_v, {colour::floor, 0, false, offset_edge}, 1);
  scene.sphere({s0, r});
  scene.sphere({end, r}, colour::amber, 0.5);
  scene.arrow(s0, end);
  scene.arrow(middle - 0.8 * half_u - 0.7 * half_v, middle - 0.8 * half_u - 0.7 * half_v + r * n,
              {colour::ink, 2.4});
  scene.dot(s0);
  scene.dot(end);
  const Vector over = n.dot(view.up()) > 0.5 ? n : view.up();
  scene.label("{/:Italic S}_0", s0 + r * over, 0, 0.9);
  scene.label(contact ? "{/:Italic S}({/:Italic t})" : "{/:Italic S}_1", end, 2.0, 0.4);
  scene.label(contact ? "{/:Italic t}{/:Bold V}" : "{/:Bold V}", 0.5 * (s0 + end), 1.2, 0.5, colour::red);
  scene.label("{/:Bold N}", middle - 0.8 * half_u - 0.7 * half_v + r * n, 1.4, -0.4);
  scene.label("{/:Italic E}", middle + half_u + half_v, 0.6, 0, colour::blue, Align::left);
  scene.label("{/:Italic E}′", middle + half_u + half_v + r * n, 0.6, 0, colour::grey, Align::left);
  if (contact) {
    scene.dot(contact->point());
    scene.label("{/:Italic C}", contact->point(), 1.1, -0.4);
  }
  Figure figure(studio, "sweep", scene.size());
  scene.draw(figure);
  figure.draw();
}
