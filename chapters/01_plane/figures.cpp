#include "figures.hpp"

#include <algorithm>
#include <cmath>

#include "first_contact/figure/framing.hpp"
#include "first_contact/figure/scene.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

namespace {

const Pen plane_edge{colour::blue, 1.2};
const Pen offset_edge{colour::grey, 1.2, true};

// Figure 2: a plane E is all points Q with (Q - P) at right angles to N.
void draw_definition(const Studio& studio) {
  figure::Scene scene({66, 28});
  const Point p(-0.5, 0.1, 0), q(1.2, -0.55, 0);
  scene.patch({0, 0, 0}, {2.1, 0, 0}, {0, 1.5, 0}, {colour::floor, 1, false, plane_edge}, -1);
  const double corner = 0.2;
  const Vector along = corner * (q - p).normalized(), up(0, 0, corner);
  scene.line({p + along, p + along + up, p + up}, {colour::grey, 1.2});
  scene.arrow(p, q, {colour::green, 2.4});
  scene.arrow(p, p + Vector(0, 0, 1.5), {colour::ink, 2.4});
  scene.dot(p);
  scene.dot(q);
  scene.label("{/:Bold N}", p + Vector(0, 0, 1.5), 1.4, -0.2);
  scene.label("{/:Italic P}", p, -0.9, -0.6);
  scene.label("{/:Italic Q}", q, 1.1, -0.2);
  scene.label("{/:Italic Q} − {/:Italic P}", 0.5 * (p + q), 0.2, -1.1, colour::green);
  scene.label("{/:Italic E}", {2.1, 1.5, 0}, 0.6, 0, colour::blue, Align::left);
  Figure figure(studio, "figure-02", scene.size());
  scene.draw(figure);
  figure.draw();
}

// Figure 3: the sphere touches E exactly when its centre lies on E', which is E moved out by r.
void draw_touch(const Studio& studio) {
  figure::Scene scene({72, 24});
  const double r = 0.8;
  const Point s(0.1, 0, r), foot(0.1, 0, 0);
  scene.patch({0, 0, 0}, {2.2, 0, 0}, {0, 1.4, 0}, {colour::floor, 1, false, plane_edge}, -2);
  scene.disc(foot, {0, 0, 1}, 0.62, {colour::shadow}, -1);
  scene.sphere({s, r}, colour::amber, 0.55);
  scene.patch({0, 0, r}, {2.2, 0, 0}, {0, 1.4, 0}, {colour::floor, 0, false, offset_edge}, 1);
  scene.line({s, foot}, {colour::red, 2.0});
  scene.arrow({-1.7, -0.9, 0}, {-1.7, -0.9, r}, {colour::ink, 2.4});
  scene.dot(s);
  scene.dot(foot);
  scene.label("{/:Italic S}", s, 1.0, 0.5);
  scene.label("{/:Italic C}", foot, 1.0, -0.4);
  scene.label("{/:Italic r}", 0.5 * (s + foot), 0.9, 0, colour::red);
  scene.label("{/:Bold N}", {-1.7, -0.9, r}, 1.4, -0.4);
  scene.label("{/:Italic E}", {2.2, 1.4, 0}, 0.6, 0, colour::blue, Align::left);
  scene.label("{/:Italic E}′", {2.2, 1.4, r}, 0.6, 0, colour::grey, Align::left);
  Figure figure(studio, "figure-03", scene.size());
  scene.draw(figure);
  figure.draw();
}

// What becomes of E.S = r when N has not unit length: the ball stops at the height r / |N|.
void draw_lengths(const program::Program& program) {
  struct Case {
    double length;
    std::string name;
    program::Text meaning;
  };
  const std::vector<Case> cases{
      {0.5, "½", {"floats", "懸空"}}, {1.0, "1", {"touches", "接觸"}}, {2.0, "2", {"sinks in", "陷入"}}};
  figure::Scene scene({0, 0}, 0.02);
  const double r = 0.8, apart = 2.9;
  scene.polygon({{-1.6, -0.95, 0}, {2 * apart + 1.35, -0.95, 0}, {2 * apart + 1.35, 0, 0}, {-1.6, 0, 0}},
                {colour::floor}, -2);
  double x = 0;
  for (const Case& each : cases) {
    const bool right = each.length == 1;
    const Colour tone = right ? colour::green : colour::pink;
    const Point s(x, r / each.length, 0), foot(x, 0, 0);
    scene.sphere({s, r}, colour::amber, right ? 1 : 0.55);
    scene.line({s, foot}, {tone, 2.2}, 3);
    scene.arrow({x - 1.2, 0, 0}, {x - 1.2, each.length, 0}, {colour::ink, 2.4});
    scene.dot(s);
    scene.label("|{/:Bold N}| = " + each.name, {x, -0.34, 0}, 0, 0);
    scene.label(program.say(each.meaning), {x, -0.68, 0}, 0, 0, tone);
    x += apart;
  }
  scene.line({{-1.6, 0, 0}, {2 * apart + 1.35, 0, 0}}, {colour::blue, 2}, 2);
  Figure figure(program.studio(), "unit-normal", scene.size());
  scene.draw(figure);
  figure.draw();
}

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

// The sweep of this run: start, contact or end, and the plane that the centre meets.
void draw_sweep(const Studio& studio, const Drawable& drawn) {
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
  scene.label("{/:Bold V}", 0.5 * (s0 + end), 1.2, 0.5, colour::red);
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

}  // namespace

void draw_plane_figures(const program::Program& program, const Plane& plane, const Moving<Sphere>& ball,
                        const std::optional<Contact>& contact) {
  draw_definition(program.studio());
  draw_touch(program.studio());
  draw_lengths(program);
  draw_sweep(program.studio(), drawable(plane, ball, contact));
}
