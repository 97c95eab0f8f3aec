#include "figures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "first_contact/figure/framing.hpp"
#include "first_contact/figure/scene.hpp"
#include "studies.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

namespace {

constexpr double degree = std::numbers::pi / 180;
const Pen plane_edge{colour::blue, 1.2};
const Pen offset_edge{colour::grey, 1.2, true};
const Fill plane_fill{colour::floor, 1, false, plane_edge};
const Fill offset_fill{colour::floor, 0, false, offset_edge};
const Fill solid{colour::amber, 1, true};
const Fill glass{colour::amber, 0.5, true};

Point on(const Plane& plane, const Point& p) { return p - plane.signed_distance(p) * plane.normal(); }

// Two directions that span the plane, the first along the motion where it has one.
std::pair<Vector, Vector> directions_in(const Plane& plane, const Vector& motion) {
  const Vector n = plane.normal();
  const Vector flat = motion - motion.dot(n) * n;
  const Vector u = flat.norm() > 1e-3 * motion.norm() ? Vector(flat.normalized()) : n.unitOrthogonal();
  return {u, n.cross(u)};
}

// The outline of a box seen along the plane's normal, on the plane: from each direction the farthest vertex.
std::vector<Point> shadow(const Box& box, const Plane& plane) {
  const Vector u = plane.normal().unitOrthogonal(), v = plane.normal().cross(u);
  std::vector<Point> outline;
  for (int i = 0; i < 360; ++i) {
    const Vector along = std::cos(degree * i) * u + std::sin(degree * i) * v;
    Point farthest = box.center;
    for (const Vector& axis : {box.r, box.s, box.t}) farthest += std::copysign(0.5, axis.dot(along)) * axis;
    const Point corner = on(plane, farthest);
    if (outline.empty() || (corner - outline.back()).norm() > 1e-9) outline.push_back(corner);
  }
  return outline;
}

std::vector<Point> circle(const Sphere& sphere) {
  std::vector<Point> points;
  points.reserve(181);
  for (int i = 0; i <= 180; ++i)
    points.emplace_back(sphere.center +
                        sphere.radius * Vector(std::cos(2 * degree * i), std::sin(2 * degree * i), 0));
  return points;
}

// Figure 1: a shape, its bounding box and its bounding circle.
void draw_bounding_shapes(const Studio& studio) {
  std::vector<Point> fish;
  for (int i = 0; i < 120; ++i) {
    const double a = 3 * degree * i;
    const double x = std::cos(a) - std::sin(a) * std::sin(a) / std::sqrt(2.0), y = std::cos(a) * std::sin(a);
    fish.emplace_back(0.94 * x - 0.34 * y, 0.34 * x + 0.94 * y, 0);
  }
  const Pen bound{colour::blue, 2.2}, dashed{colour::blue, 2.2, true};
  figure::Scene scene({0, 0}, 0.03);
  for (const bool round : {false, true}) {
    std::vector<Point> outline;
    for (const Point& p : fish) outline.emplace_back(p + Vector(round ? 2.5 : 0.0, 0, 0));
    scene.polygon(outline, {colour::amber, 1, false, Pen{colour::ink, 1.4}});
    scene.dot(0.62 * outline.front() + Vector(round ? 0.95 : 0.0, 0.1, 0));
    const Box box = bounding_box(outline);
    if (round)
      scene.line(circle(bounding_sphere(outline)), bound);
    else
      scene.patch(box.center, 0.5 * box.r, 0.5 * box.s, {colour::floor, 0, false, dashed}, 1);
  }
  Figure figure(studio, "figure-01", scene.size());
  scene.draw(figure);
  figure.draw();
}

// The three parts of 2 r_eff, one upon the other.
void draw_gauge(figure::Scene& scene, Point gauge, const Box& box, const Vector& n) {
  const auto measure = [&](const std::string& axis, const Vector& edge, const Colour& of) {
    const Point upper = gauge + std::abs(edge.dot(n)) * n;
    scene.line({gauge, upper}, {of, 4.0}, 3);
    scene.label("|{/:Bold " + axis + "}·{/:Bold N}|", 0.5 * (gauge + upper), 0.8, 0, of, Align::left);
    gauge = upper;
  };
  measure("S", box.s, colour::green);
  measure("R", box.r, colour::red);
  measure("T", box.t, colour::pink);
  scene.label("", gauge + Vector(0.75, 0, 0));  // room for what stands beside the gauge
}

// Figure 4: from the lowest vertex to the highest, along three edges, the box rises |R.N| + |S.N| + |T.N|;
// its centre is half as high.
void draw_effective_radius(const Studio& studio) {
  const Vector n(0, 0, 1);
  const Box box{{0, 0, 1.15}, {0.6, 1.2, 1.2}, {0.8, 0.4, -0.8}, {0.6, -0.6, 0.3}};
  const double radius = box.effective_radius(n);
  const Vector half_u(2.0, 0, 0), half_v(0, 1.3, 0), foot(0, 0, 0);
  figure::Scene scene({74, 24}, 0.05);
  scene.patch(foot, half_u, half_v, plane_fill, -3);
  scene.polygon(shadow(box, Plane(n, 0)), {colour::shadow}, -2);
  scene.patch(radius * n, half_u, half_v, offset_fill, 1);
  scene.box(box, glass);
  const Point lowest = lowest_vertices(box, n).col(0);
  const Point second = lowest - box.s, third = second + box.r;
  scene.arrow(second, lowest, {colour::green, 2.4});
  scene.arrow(second, third, {colour::red, 2.4});
  scene.arrow(third, third + box.t, {colour::pink, 2.4});
  scene.label("{/:Bold S}", 0.5 * (second + lowest), -1.0, -0.7, colour::green);
  scene.label("{/:Bold R}", 0.62 * second + 0.38 * third, -1.1, 0.5, colour::red);
  scene.label("{/:Bold T}", third + 0.5 * box.t, -0.2, 0.9, colour::pink);

  draw_gauge(scene, half_u + half_v, box, n);
  scene.line({box.center, foot}, {colour::ink, 2.0}, 2);
  scene.dot(box.center);
  scene.dot(foot);
  scene.dot(lowest);
  scene.label("{/:Italic Q}", box.center, 0.9, 0.4);
  scene.label("{/:Italic r}_{eff}", 0.76 * box.center, 1.8, 0);
  scene.label("{/:Italic C}", lowest, 0.2, -0.9);
  const Point corner = -half_u - half_v;
  scene.label("{/:Italic E}", corner, -0.7, 0, colour::blue, Align::right);
  scene.label("{/:Italic E}′", corner + radius * n, -0.7, 0, colour::grey, Align::right);
  scene.label("", corner - Vector(0.25, 0, 0));
  scene.arrow(corner + Vector(0.3, 0.25, 0), corner + Vector(0.3, 0.25, 0.8), {colour::ink, 2.4});
  scene.label("{/:Bold N}", corner + Vector(0.3, 0.25, 0.8), 1.5, -0.3);
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
  scene.label("{/:Bold V}", 0.5 * (q0 + end), 1.3, 0.8, colour::red);
}

void name_planes(figure::Scene& scene, const Point& corner, const Point& foot, const Vector& offset) {
  scene.arrow(foot, foot + offset, {colour::ink, 2.4});
  scene.label("{/:Bold N}", foot + offset, 1.6, -0.4);
  scene.label("{/:Italic E}", corner, 0.6, 0, colour::blue, Align::left);
  scene.label("{/:Italic E}′", corner + offset, 0.6, 0, colour::grey, Align::left);
}

// Figure 5: the sweep of this run. The box meets E when its centre meets E', which is E moved out by r_eff.
void draw_sweep(const Studio& studio, const Drawable& drawn) {
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
  const View view{66, 14};
  figure::Scene scene(view, 0.03);
  scene.patch({0, 0, 0}, {4.1, 0, 0}, {0, 1.5, 0}, plane_fill, -3);
  for (const auto& landing : box_chapter::landings()) {
    const ContactPoints& points = landing.contact.points;
    scene.polygon(shadow(landing.box, ground), {colour::shadow}, -2);
    scene.box(landing.box, glass);
    mark_contact(scene, points);
    for (Eigen::Index i = 0; i < points.cols(); ++i) {  // each name outwards of its point, in the picture
      const Vector away = points.col(i) - landing.contact.point();
      const Eigen::Vector2d out = Eigen::Vector2d(away.dot(view.right()), away.dot(view.up())).normalized();
      const bool alone = points.cols() == 1;
      scene.label(name_of(points, i), points.col(i), alone ? 0.2 : 1.5 * out.x(),
                  alone ? -0.9 : 0.9 * out.y());
    }
  }
  Figure figure(studio, "landings", scene.size(900));
  scene.draw(figure);
  figure.draw();
}

// Where a box pierces the plane z = 0: a convex polygon, in order around its middle.
std::vector<Point> waterline(const Box& box) {
  const auto corners = box.vertices();
  std::vector<Point> crossings;
  Point middle = Point::Zero();
  for (unsigned i = 0; i < 8; ++i)
    for (unsigned axis = 1; axis < 8; axis *= 2) {
      const Point &p = corners[i], &q = corners[i ^ axis];
      if (i & axis || (p.z() > 0) == (q.z() > 0)) continue;
      crossings.emplace_back(p + p.z() / (p.z() - q.z()) * (q - p));
      middle += crossings.back();
    }
  middle /= static_cast<double>(crossings.size());
  std::sort(crossings.begin(), crossings.end(), [&](const Point& a, const Point& b) {
    return std::atan2(a.y() - middle.y(), a.x() - middle.x()) <
           std::atan2(b.y() - middle.y(), b.x() - middle.x());
  });
  return crossings;
}

// The paper's vertices with one common sign for the three axes, and all eight: stopped where the lowest of
// them touches.
void draw_signs(const program::Program& program) {
  const View view{76, 14};
  figure::Scene scene(view, 0.03);
  scene.patch({0, 0, 0}, {3.0, 0, 0}, {0, 1.5, 0}, plane_fill, -3);
  const Box upright = box_chapter::landings()[0].box;
  for (const bool printed : {true, false}) {
    const Vector half = 0.5 * (upright.r + upright.s + upright.t);
    const Point center(printed ? -1.5 : 1.5, 0, printed ? half.z() : upright.center.z());
    const Box box{center, upright.r, upright.s, upright.t};
    scene.polygon(shadow(box, Plane({0, 0, 1}, 0)), {colour::shadow}, -2);
    scene.box(box, glass);
    if (printed) {
      auto line = waterline(box);
      scene.polygon(line, {colour::pink, 0.45}, 2);
      line.push_back(line.front());
      scene.line(line, {colour::pink, 2.0}, 3);
      for (const double sign : {1.0, -1.0}) scene.dot(center + sign * half, colour::pink);
    } else {
      for (const Point& vertex : box.vertices()) scene.dot(vertex, colour::green);
    }
    scene.dot(center);
    scene.label("{/:Italic Q}", center, 0.9, 0.5);
    const program::Text said = printed ? program::Text{"one common sign", "同一符號"}
                                       : program::Text{"three signs of their own", "三個獨立符號"};
    const Point below = center.x() * Vector::UnitX();
    scene.label(program.say(said), below - (1.5 + below.dot(view.up())) * view.up(), 0, 0,
                printed ? colour::pink : colour::green);
  }
  Figure figure(program.studio(), "signs", scene.size(900));
  scene.draw(figure);
  figure.draw();
}

// A leaning plank in its bounding sphere, its upright and its turned box, each with its volume beside the
// plank's.
void draw_tightness(const Studio& studio) {
  const box_chapter::Bounded plank = box_chapter::bounded_shapes()[0];
  const Fill hull{colour::sky, 0.22, true};
  const View view{76, 20};
  figure::Scene scene(view, 0.04);
  double place = 0;
  const auto show = [&](double bounding_volume) {
    Rigid shift = Rigid::moved_by(place * view.right());
    scene.box(shift.box(plank.turned), solid, 0);
    scene.label(box_chapter::rounded(bounding_volume / plank.volume, 1) + " {/:Italic V}",
                shift.translation() - 2.05 * view.up());
    place += 3.85;
    return shift;
  };
  scene.sphere(show(volume(plank.sphere)).sphere(plank.sphere), colour::sky, 0.22, 1);
  scene.box(show(volume(plank.upright)).box(plank.upright), hull, 1);
  const Box& snug = plank.turned;  // drawn a little too large, or nothing of it would be seen
  const auto looser = [](const Vector& axis) { return Vector(axis + 0.14 * axis.normalized()); };
  scene.box(show(volume(snug)).box({snug.center, looser(snug.r), looser(snug.s), looser(snug.t)}), hull, 1);
  Figure figure(studio, "bounding", scene.size(900));
  scene.draw(figure);
  figure.draw();
}

// What a camera sees: the frustum, boxes that are kept (green, or amber if out of view) and rejected (grey).
void draw_frustum(const Studio& studio) {
  const Transform back = box_chapter::camera().inverse();
  const auto corner = [&](double x, double y, double z) { return back.point({x, y, z}); };
  figure::Scene scene({42, -12}, 0.03);
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
  const auto sights = box_chapter::sights();
  for (const auto& sight : sights) {
    const Colour& kept = &sight == &sights.back() ? colour::amber : colour::green;
    scene.box(sight.box, {sight.rejected ? colour::pale : kept, 1, true}, 0);
    const Point above = sight.box.center + Vector(0, 0.5, 0.75);
    if (sight.rejected) scene.label("{/:Italic E}·{/:Italic Q} < −{/:Italic r}_{eff}", above, 0, 0.4);
    scene.label("", sight.box.center + Vector(0.6, 0, 0));  // room for what stands above
  }
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
  draw_sweep(program.studio(), drawable(plane, moving, contact));
  draw_landings(program.studio());
  draw_signs(program);
  draw_tightness(program.studio());
  draw_frustum(program.studio());
}
