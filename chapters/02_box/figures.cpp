#include "figures.hpp"

#include <cmath>
#include <cstdio>

#include "first_contact/figure/scene.hpp"
#include "studies.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

namespace {

const Pen plane_edge{colour::blue, 1.2};
const Pen offset_edge{colour::grey, 1.2, true};
const Fill plane_fill{colour::floor, 1, false, plane_edge};
const Fill offset_fill{colour::floor, 0, false, offset_edge};
const Fill solid{colour::amber, 1, true};
const Fill glass{colour::amber, 0.5, true};

std::string number(const char* form, double value) {
  char text[64];
  std::snprintf(text, sizeof text, form, value);
  return text;
}

Point on(const Plane& plane, const Point& p) { return p - plane.signed_distance(p) * plane.normal(); }

// Two directions that span the plane, the first along the motion where it has one.
std::pair<Vector, Vector> directions_in(const Plane& plane, const Vector& motion) {
  const Vector n = plane.normal();
  const Vector flat = motion - motion.dot(n) * n;
  const Vector u = flat.norm() > 1e-3 * motion.norm() ? Vector(flat.normalized()) : n.unitOrthogonal();
  return {u, n.cross(u)};
}

// What light from along the normal would leave dark: the outline of the box's vertices on the plane.
std::vector<Point> shadow(const Box& box, const Plane& plane) {
  const Vector n = plane.normal(), u = n.unitOrthogonal(), v = n.cross(u);
  const Point middle = on(plane, box.center);
  std::vector<std::pair<double, Point>>
      around;  // the hull of a box seen from anywhere: each extreme vertex, by angle
  for (int i = 0; i < 360; ++i) {
    const double a = 0.0174532925199433 * i;
    const Vector along = std::cos(a) * u + std::sin(a) * v;
    Vector reach = Vector::Zero();
    for (const Vector& axis : {box.r, box.s, box.t}) reach += std::copysign(0.5, axis.dot(along)) * axis;
    const Point corner = middle + on(plane, box.center + reach) - middle;
    if (around.empty() || (corner - around.back().second).norm() > 1e-9) around.emplace_back(a, corner);
  }
  std::vector<Point> outline;
  for (const auto& [angle, corner] : around) outline.push_back(corner);
  return outline;
}

// Figure 1: a shape, its bounding box and its bounding circle.
void draw_bounding_shapes(const Studio& studio) {
  std::vector<Point> fish;
  for (int i = 0; i < 120; ++i) {
    const double a = 0.0523598775598299 * i;
    const double x = std::cos(a) - std::sin(a) * std::sin(a) / std::sqrt(2.0), y = std::cos(a) * std::sin(a);
    fish.emplace_back(0.94 * x - 0.34 * y, 0.34 * x + 0.94 * y, 0);
  }
  figure::Scene scene({0, 0});
  for (const double shift : {0.0, 2.9}) {
    std::vector<Point> outline;
    for (const Point& p : fish) outline.push_back(p + Vector(shift, 0, 0));
    scene.polygon(outline, {colour::amber, 1, false, Pen{colour::ink, 1.4}});
    scene.dot(Point(0.62 + shift, 0.36, 0));
    const Box box = bounding_box(outline);
    const Sphere circle = bounding_sphere(outline);
    if (shift == 0)
      scene.patch(box.center, 0.5 * box.r, 0.5 * box.s,
                  {colour::floor, 0, false, Pen{colour::blue, 2.2, true}}, 1);
    if (shift != 0)
      scene.disc(circle.center, {0, 0, 1}, circle.radius, {colour::floor, 0, false, Pen{colour::green, 2.2}},
                 1);
  }
  Figure figure(studio, "figure-01", scene.size());
  scene.draw(figure);
  figure.draw();
}

// The way from the centre to the lowest vertex: down half of each axis, in turn.
struct Step {
  Vector half;
  std::string name, rise;
  Colour colour;
};

std::vector<Step> way_down(const Box& box, const Vector& n) {
  std::vector<Step> steps{
      {box.r, "R", "", colour::red}, {box.s, "S", "", colour::green}, {box.t, "T", "", colour::pink}};
  for (Step& step : steps) {
    const bool up = step.half.dot(n) > 0;
    step.half *= up ? -0.5 : 0.5;
    step.rise = "½|{/:Bold " + step.name + "}·{/:Bold N}|";
    step.name = (up ? "−½{/:Bold " : "+½{/:Bold ") + step.name + "}";
  }
  return steps;
}

// Figure 4: the effective radius is the sum of what the three half axes rise.
void draw_effective_radius(const Studio& studio) {
  const Vector up(0, 0, 1);
  const Box box{{0, 0, 1.15}, {0.6, 1.2, 1.2}, {0.8, 0.4, -0.8}, {0.6, -0.6, 0.3}};
  const double radius = box.effective_radius(up);
  const Vector half_u(2.0, 0, 0), half_v(0, 1.3, 0);
  figure::Scene scene({74, 24});
  scene.patch({0, 0, 0}, half_u, half_v, plane_fill, -3);
  scene.polygon(shadow(box, Plane(up, 0)), {colour::shadow}, -2);
  scene.patch(radius * up, half_u, half_v, offset_fill, 1);
  scene.box(box, glass);
  Point at = box.center, gauge = half_u - half_v + radius * up;
  for (const Step& step : way_down(box, up)) {
    const Point next = at + step.half, lower = gauge + step.half.z() * up;
    scene.arrow(at, next, {step.colour, 2.4});
    scene.line({gauge, lower}, {step.colour, 4.0}, 3);
    scene.label(step.name, 0.5 * (at + next), 1.6, 0.3, step.colour);
    scene.label(step.rise, 0.5 * (gauge + lower), 0.8, 0, step.colour, Align::left);
    at = next;
    gauge = lower;
  }
  scene.dot(box.center);
  scene.dot(at);
  scene.label("{/:Italic Q}", box.center, -0.9, 0.5);
  scene.label("{/:Italic C}", at, 0.2, -0.9);
  Figure figure(studio, "figure-04", scene.size());
  scene.draw(figure);
  figure.draw();
}

std::string name_of(const ContactPoints& points, Eigen::Index i) {
  return "{/:Italic C}" + (points.cols() > 1 ? "_" + std::to_string(i + 1) : std::string());
}

// What touches, on top of all: the vertex, the edge with its ends, or the face with its corners.
void mark_contact(figure::Scene& scene, const ContactPoints& points) {
  std::vector<Point> corners;
  for (const auto& p : points.colwise()) corners.emplace_back(p);
  if (corners.size() == 4) scene.polygon(corners, {colour::red, 0.25}, 3);
  if (corners.size() > 2) corners.push_back(corners.front());
  if (corners.size() > 1) scene.line(corners, {colour::red, 2.4}, 4);
  for (const Point& p : corners) scene.dot(p, colour::red);
}

// Figure 5: the sweep of this run. The box meets E when its centre meets E', which is E moved out by r_eff.
void draw_sweep(const Studio& studio, const Plane& plane, const Moving<Box>& moving,
                const std::optional<Contact>& contact) {
  const Box& start = moving.shape;
  const Point q0 = start.center, q1 = q0 + moving.displacement;
  const Point end = q0 + (contact ? contact->time : 1.0) * moving.displacement;
  const Rigid shift = Rigid::moved_by(end - q0);
  const Vector n = std::copysign(1.0, plane.signed_distance(q0)) * plane.normal();
  const double radius = start.effective_radius(n);
  const auto [u, v] = directions_in(plane, moving.displacement);
  const double size = std::max({start.r.norm(), start.s.norm(), start.t.norm()});
  const double reach = 0.5 * (on(plane, q1) - on(plane, q0)).norm() + 0.9 * size;
  const Point middle = 0.5 * (on(plane, q0) + on(plane, q1));
  const Vector half_u = reach * u, half_v = 0.75 * reach * v;

  figure::Scene scene({72, 24});
  scene.patch(middle, half_u, half_v, plane_fill, -3);
  scene.polygon(shadow(start, plane), {colour::shadow, 0.6}, -2);
  scene.polygon(shadow(shift.box(start), plane), {colour::shadow}, -1);
  scene.patch(middle + radius * n, half_u, half_v, offset_fill, 1);
  scene.box(start, solid);
  scene.box(shift.box(start), glass);
  scene.arrow(q0, end);
  if (contact && (q1 - end).norm() > 0.02 * moving.displacement.norm()) {
    scene.line({end, q1}, {colour::red, 1.4, true});
    scene.dot(q1);
    scene.label("{/:Italic Q}_1", q1, 1.3, -0.2);
  }
  const Point foot = middle - 0.85 * half_u - 0.75 * half_v;
  scene.arrow(foot, foot + radius * n, {colour::ink, 2.4});
  scene.dot(q0);
  scene.dot(end);
  scene.label("{/:Italic Q}_0", q0, -1.2, 0.5);
  scene.label(contact ? "{/:Italic Q}({/:Italic t})" : "{/:Italic Q}_1", end, 1.9, 0.5);
  scene.label("{/:Bold V}", 0.5 * (q0 + end), 1.2, 0.5, colour::red);
  scene.label("{/:Bold N}", foot + radius * n, 1.4, -0.4);
  scene.label("{/:Italic E}", middle + half_u + half_v, 0.6, 0, colour::blue, Align::left);
  scene.label("{/:Italic E}′", middle + half_u + half_v + radius * n, 0.6, 0, colour::grey, Align::left);
  if (contact) {
    mark_contact(scene, contact->points);
    for (Eigen::Index i = 0; i < contact->points.cols(); ++i)
      scene.label(name_of(contact->points, i), contact->points.col(i), 0.2, -0.9);
  }
  Figure figure(studio, "figure-05", scene.size());
  scene.draw(figure);
  figure.draw();
}

// One brick on a vertex, an edge and a face.
void draw_landings(const Studio& studio) {
  const Plane ground({0, 0, 1}, 0);
  figure::Scene scene({68, 16});
  scene.patch({0, 0, 0}, {4.0, 0, 0}, {0, 1.3, 0}, plane_fill, -3);
  for (const auto& landing : box_chapter::landings()) {
    const ContactPoints& points = landing.contact.points;
    scene.polygon(shadow(landing.box, ground), {colour::shadow}, -2);
    scene.box(landing.box, glass);
    mark_contact(scene, points);
    const Point middle = landing.contact.point();
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      const Vector away = points.cols() > 1 ? Vector((points.col(i) - middle).normalized()) : Vector::Zero();
      scene.label(name_of(points, i), points.col(i), 1.2 * away.x(),
                  points.cols() > 1 ? 0.6 * away.y() - 0.3 : -0.9);
    }
  }
  Figure figure(studio, "landings", scene.size(900));
  scene.draw(figure);
  figure.draw();
}

// A leaning plank in its bounding sphere, its upright and its turned box, each with its volume beside the
// plank's.
void draw_tightness(const Studio& studio) {
  const box_chapter::Bounded plank = box_chapter::bounded_shapes()[0];
  const Box inside = plank.turned;
  const Fill hull{colour::sky, 0.22, true};
  figure::Scene scene({76, 20});
  int place = 0;
  const auto show = [&](double bounding_volume) {
    const Vector shift(3.7 * place++, 0, 0);
    scene.box(Rigid::moved_by(shift).box(inside), solid, 0);
    scene.label("{/:Italic V} × " + number("%.1f", bounding_volume / plank.volume),
                shift - Vector(0, 0, 2.0));
    return Rigid::moved_by(shift);
  };
  scene.sphere(show(volume(plank.sphere)).sphere(plank.sphere), colour::sky, 0.22, 1);
  scene.box(show(volume(plank.upright)).box(plank.upright), hull, 1);
  scene.box(show(volume(plank.turned)).box(plank.turned), hull, 1);
  Figure figure(studio, "bounding", scene.size(900));
  scene.draw(figure);
  figure.draw();
}

// What a camera sees: the frustum, boxes that are kept (green) and boxes that are rejected (grey).
void draw_frustum(const Studio& studio) {
  const Transform back = box_chapter::camera().inverse();
  const auto corner = [&](double x, double y, double z) { return back.point({x, y, z}); };
  figure::Scene scene({52, -32});
  const std::array<Eigen::Vector2d, 4> around{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  std::vector<Point> near, far;
  for (const auto& p : around) {
    near.push_back(corner(p.x(), p.y(), -1));
    far.push_back(corner(p.x(), p.y(), 1));
    scene.line({Point(0, 0, 0), near.back()}, offset_edge, 0);
  }
  const Pen edge{colour::blue, 1.4};
  scene.polygon(far, {colour::sky, 0.18, false, edge}, -2);
  scene.polygon({near[0], near[1], far[1], far[0]}, {colour::sky, 0.30, false, edge}, -2);
  for (const auto& sight : box_chapter::sights())
    scene.box(sight.box, {sight.rejected ? colour::grey : colour::green, 1, true}, 0);
  scene.polygon(near, {colour::sky, 0.18, false, edge}, 1);
  for (const std::size_t i : {2U, 3U}) scene.line({near[i], far[i]}, edge, 1);
  scene.dot({0, 0, 0});
  Figure figure(studio, "frustum", scene.size());
  scene.draw(figure);
  figure.draw();
}

}  // namespace

void draw_box_figures(const program::Program& program, const Plane& plane, const Moving<Box>& moving,
                      const std::optional<Contact>& contact) {
  draw_bounding_shapes(program.studio());
  draw_effective_radius(program.studio());
  draw_sweep(program.studio(), plane, moving, contact);
  draw_landings(program.studio());
  draw_tightness(program.studio());
  draw_frustum(program.studio());
}
