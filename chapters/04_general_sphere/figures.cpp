#include "figures.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "first_contact/figure/scene.hpp"
#include "first_contact/mesh_io/mesh_file.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "jaw.hpp"
#include "places.hpp"
#include "rounded.hpp"
#include "scenes.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

namespace {

constexpr View from_above{0, 0};  // x to the right, y upwards: for pictures in the plane
constexpr double pi = std::numbers::pi;

const Fill solid{colour::floor, 1, false, Pen{colour::blue, 1.6}};
const Pen moved_out{colour::grey, 1.4, true};

Point at(double x, double y) { return {x, y, 0}; }

// Part of a circle, by the angles of its ends in degrees.
std::vector<Point> arc(const Point& center, double radius, double from = 0, double to = 360) {
  std::vector<Point> points;
  for (int i = 0; i <= 60; ++i) {
    const double angle = (from + (to - from) * i / 60) * pi / 180;
    points.emplace_back(center + radius * at(std::cos(angle), std::sin(angle)));
  }
  return points;
}

void finish(const Studio& studio, const std::string& name, const figure::Scene& scene) {
  Figure figure(studio, name, scene.size());
  scene.draw(figure);
  figure.draw();
}

// Figure 6: the centres of all spheres in contact with a solid lie on the solid moved out by r, round at its
// corners.
void draw_moved_out(const Studio& studio) {
  figure::Scene scene(from_above);
  const double r = 0.7;
  const std::vector<Point> corners{at(-2.2, -1), at(1.6, -1), at(2.1, 0.2), at(0.9, 1), at(-1.7, 0.8)};
  scene.polygon(corners, solid);
  scene.line(rounded_outline(corners, r), moved_out);
  const Vector along = corners[4] - corners[3], n = Vector(along.y(), -along.x(), 0).normalized();
  const Point foot = corners[3] + 0.62 * along, c = foot + r * n;
  const Point corner = corners[2] + r * at(0.9, 0.2).normalized();
  scene.sphere({c, r}, colour::amber, 0.5);
  scene.sphere({corner, r}, colour::amber, 0.25);
  scene.line({c, foot}, {colour::red, 2.0});
  scene.line({corner, corners[2]}, {colour::red, 2.0});
  scene.dot(c);
  scene.dot(corner);
  scene.label("{/:Italic C}", c, -0.9, 0.5);
  scene.label("{/:Italic C}", corner, 1.0, 0.3);
  scene.label("{/:Italic r}", 0.5 * (c + foot), 0.8, 0, colour::red);
  finish(studio, "figure-06", scene);
}

// Figure 7: the path meets the moved-out face at A before it comes to the cylinder, inside, at B.
void draw_face_first(const Studio& studio) {
  figure::Scene scene(from_above);
  const double r = 1;
  scene.polygon({at(-2.6, -1.3), at(0, -1.3), at(0, 0), at(-2.6, 0)}, {colour::floor});
  scene.line({at(0, -1.3), at(0, 0), at(-2.6, 0)}, {colour::blue, 1.6});
  scene.line({at(-2.6, r), at(0, r)}, moved_out);
  scene.line({at(r, 0), at(r, -1.3)}, moved_out);
  scene.line(arc(at(0, 0), r), {colour::green, 1.4, true});
  const Point start = at(-2.0, 2.3), a = at(-1.05, r);
  const Vector path = a - start;
  const Contact b =
      *sweep(Moving<Sphere>{{start, r}, 3 * path}, Mesh({at(0, 0), at(0, 0), at(0, 0)}, {{0, 1, 2}}));
  const Point inside = start + b.time * 3 * path;
  scene.line({start, start + 2.6 * path}, {colour::red, 1.0, true});
  scene.arrow(start, a);
  scene.dot(a);
  scene.dot(inside);
  scene.dot(at(0, 0));
  scene.label("{/:Italic A}", a, 0.9, 0.7);
  scene.label("{/:Italic B}", inside, -1.1, -0.3);
  scene.label("{/:Italic r}", at(0.62, 0.42), 0, 0, colour::green);
  scene.line({at(0, 0), at(std::sqrt(0.5), std::sqrt(0.5))}, {colour::green, 1.4});
  finish(studio, "figure-07", scene);
}

// Figure 8: in a valley the cylinder about the edge lies wholly within the moved-out solid.
void draw_valley(const Studio& studio) {
  figure::Scene scene(from_above);
  const double r = 0.9;
  scene.polygon({at(-1.0, -0.9), at(3.2, -0.9), at(3.2, 0), at(0, 0), at(0, 2.5), at(-1.0, 2.5)},
                {colour::floor});
  scene.line({at(3.2, 0), at(0, 0), at(0, 2.5)}, {colour::blue, 1.6});
  scene.line({at(3.2, r), at(r, r), at(r, 2.5)}, moved_out);
  scene.line(arc(at(0, 0), r), {colour::green, 1.4, true});
  scene.sphere({at(r, r), r}, colour::amber, 0.5);
  scene.dot(at(0, 0));
  scene.dot(at(r, r));
  scene.label("{/:Italic C}", at(r, r), -0.9, 0.7);
  scene.arrow(at(3.0, 2.2), at(r + 0.06, r + 0.04));
  finish(studio, "figure-08", scene);
}

// Figure 9: the vertex A, where the bottom of a jar begins to rise, has its ball within the moved-out jar.
void draw_jar(const Studio& studio) {
  figure::Scene scene(from_above);
  const double r = 0.5;
  const std::vector<Point> inner{at(-2, 2.2), at(-2, 0), at(-1.1, 0), at(0, 0.55),
                                 at(1.1, 0),  at(2, 0),  at(2, 2.2)};
  std::vector<Point> wall = inner;
  for (const Point& p : {at(2.3, 2.2), at(2.3, -0.4), at(-2.3, -0.4), at(-2.3, 2.2)}) wall.push_back(p);
  scene.polygon(wall, {colour::floor});
  scene.line(inner, {colour::blue, 1.6});
  const Vector n = Vector(-0.55, 1.1, 0).normalized();
  const double angle = std::atan2(n.y(), n.x()) * 180 / pi, bend = r * std::tan((90 - angle) / -2 * pi / 180);
  std::vector<Point> half{at(-2 + r, 2.2), at(-2 + r, r), at(-1.1 - bend, r)};
  for (const Point& p : arc(at(0, 0.55), r, angle, 90)) half.push_back(p);
  std::vector<Point> centres = half;
  for (auto p = half.rbegin(); p != half.rend(); ++p) centres.push_back(at(-p->x(), p->y()));
  scene.line(centres, moved_out);
  scene.line(arc(at(-1.1, 0), r), {colour::green, 1.4, true});
  scene.dot(at(-1.1, 0));
  scene.label("{/:Italic A}", at(-1.1, 0), 0, -0.9);
  scene.sphere({at(-1.1 - bend, r), r}, colour::amber, 0.4);
  scene.dot(at(-1.1 - bend, r));
  finish(studio, "figure-09", scene);
}

// As printed, the cylinder's axis is moved out as well, and the ball stops in the air.
void draw_printed_cylinder(const program::Program& program) {
  figure::Scene scene(from_above);
  const double r = 0.8;
  scene.polygon({at(-2, -1.4), at(0, -1.4), at(0, 0), at(-2, 0)}, {colour::floor});
  scene.line({at(0, -1.4), at(0, 0), at(-2, 0)}, {colour::blue, 1.6});
  scene.line({at(-2, r), at(r, r), at(r, -1.4)}, moved_out);
  const Vector toward = at(-1, -1).normalized();
  const Point edge = at(0, 0), moved = at(r, r), start = at(2.3, 2.3);
  const Point early = moved - r * toward, right = edge - r * toward;
  scene.line(arc(moved, r), {colour::pink, 1.4, true});
  scene.line(arc(edge, r), {colour::green, 1.4, true});
  scene.sphere({early, r}, colour::pink, 0.25);
  scene.sphere({right, r}, colour::amber, 0.5);
  scene.arrow(start, right);
  for (const Point& p : {edge, moved, early, right}) scene.dot(p);
  scene.label(program.say({"as printed", "論文所印"}), early + at(-0.9 * r, r), -0.4, 0, colour::pink,
              Align::right);
  scene.label(program.say({"corrected", "修正"}), at(r, -0.25), 0.8, -1.2, colour::green, Align::left);
  finish(program.studio(), "printed-cylinder", scene);
}

// The paper's order, taken literally: the floor comes first in the list, and the ball is let through the step
// above it.
void draw_order(const program::Program& program) {
  figure::Scene scene(from_above);
  const double r = 0.5;
  const Moving<Sphere> falling{{{1, 0, 3}, r}, {0, 0, -3}};
  const Mesh stairs = general_sphere_chapter::step();
  const auto height = [&](double t) { return falling.shape.center.z() + t * falling.displacement.z(); };
  const double through = height(general_sphere_chapter::first_face_in_the_list(falling, stairs)->time);
  const double touching = height(sweep(falling, stairs)->time);
  scene.polygon({at(-2, -0.25), at(2, -0.25), at(2, 0), at(-2, 0)}, {colour::floor}, -2);
  scene.polygon({at(0, 0), at(2, 0), at(2, 1), at(0, 1)}, {colour::floor}, -2);
  scene.line({at(-2, 0), at(2, 0)}, {colour::blue, 2.4}, -1);
  scene.line({at(0, 0), at(0, 1), at(2, 1)}, {colour::blue, 2.4}, -1);
  scene.line({at(-2, r), at(2, r)}, moved_out);
  scene.line({at(0, 1 + r), at(2, 1 + r)}, moved_out);
  scene.line({at(1, touching), at(1, through)}, {colour::pink, 1.4, true}, 3);
  scene.sphere({at(1, through), r}, colour::pink, 0.3, 1);
  scene.sphere({at(1, touching), r}, colour::amber, 0.55, 2);
  scene.arrow(at(1, 2.7), at(1, touching), {colour::red, 2.4}, 4);
  scene.dot(at(1, through), colour::pink);
  scene.dot(at(1, touching));
  scene.label("1", at(-1.8, 0), 0, 0.9, colour::blue);
  scene.label("2", at(0.2, 1), 0, 0.9, colour::blue);
  scene.label(program.say({"as printed", "論文所印"}), at(2, through), 0.8, 0, colour::pink, Align::left);
  scene.label(program.say({"corrected", "修正"}), at(2, touching), 0.8, 0, colour::green, Align::left);
  scene.label("", at(2.8, 0));  // room for both
  finish(program.studio(), "order", scene);
}

// All faces, edges and vertices moved out: the Minkowski sum of the solid and a ball.
void draw_minkowski_sum(const Studio& studio) {
  figure::Scene scene({66, 32}, 0.09);
  const Environment solid_body{general_sphere_chapter::cut_cube()};
  const double r = 0.35;
  scene.mesh(solid_body.mesh(), {colour::sky, 1, true}, true, 0);
  draw_ridges(scene, solid_body, {66, 32}, 1);
  draw_rounded(scene, solid_body, r, {66, 32}, 2);
  scene.arrow({-0.1, 0.3, 0.8}, {-0.1, 0.3, 0.8 + r}, {colour::red, 2.4}, 3);
  scene.label("{/:Italic r}", {-0.1, 0.3, 0.8 + 0.5 * r}, 0.9, 0, colour::red);
  scene.label("{/:Italic P}", {-0.1, -0.8, -0.1}, 0, 0);
  scene.label("{/:Italic P} ⊕ {/:Italic B}_{/:Italic r}", {1.15, 1.15, 1.15}, 0, 1.6, colour::ink,
              Align::right);
  finish(studio, "minkowski-sum", scene);
}

// A ray against a triangle: through the face, and exactly through an edge.
void draw_ray(const Studio& studio) {
  figure::Scene scene({64, 30});
  const Point a(-1.4, -0.9, 0), b(1.6, -0.7, 0), c(0.2, 1.3, 0.2);
  scene.polygon({a, b, c}, solid);
  const Point hit = 0.3 * a + 0.35 * b + 0.35 * c, seam = 0.45 * b + 0.55 * c;
  for (const Point& p : {hit, seam}) {
    const Vector down(0.25, 0.2, -1);
    scene.line({p, p + 0.75 * down}, {colour::red, 1.2, true}, -1);
    scene.arrow(p - 1.5 * down, p);
    scene.dot(p);
  }
  scene.label("{/:Italic a}", a, -0.9, -0.3);
  scene.label("{/:Italic b}", b, 0.9, -0.3);
  scene.label("{/:Italic c}", c, 0, 0.8);
  scene.label("{/:Italic C}", hit, 0.9, -0.5);
  finish(studio, "ray", scene);
}

Colour colour_of(Feature feature) {
  return feature == Feature::face ? colour::amber : feature == Feature::edge ? colour::green : colour::pink;
}

// Balls flung at the bunny from all around, where they first touch it: on a face, an edge or a vertex.
void draw_bunny(const program::Program& program) {
  const Environment bunny{read_mesh(std::string(places::meshes) + "/bunny.off")};
  Eigen::AlignedBox3d bounds;
  for (const Point& p : bunny.mesh().vertices()) bounds.extend(p);
  const double size = bounds.sizes().maxCoeff();
  const View view{74, 20};
  figure::Scene scene(view);
  scene.mesh(bunny.mesh(), {colour::sky, 1, true}, true);
  for (int i = 0; i < 12; ++i) {
    const double turn = (view.turn - 175 + 170.0 * i / 11) * pi / 180;
    const Vector out(std::cos(turn), std::sin(turn), 0.15 + 0.55 * std::cos(2.4 * i));
    const Point from = bounds.center() + 0.95 * size * out;
    const Moving<Sphere> ball{{from, 0.035 * size}, bounds.center() - from};
    const auto contact = sweep(ball, bunny);
    if (!contact) continue;
    const Point touching = from + contact->time * ball.displacement;
    scene.arrow(touching + 0.3 * size * out.normalized(), touching, {colour::red, 1.4}, 1);
    scene.sphere({touching, ball.shape.radius}, colour_of(contact->feature), 1, 2, 9);
  }
  const Point legend = bounds.center() - 0.62 * size * view.up() - 0.52 * size * view.right();
  const std::array<std::pair<Feature, program::Text>, 3> names{{{Feature::face, {"face", "面"}},
                                                                {Feature::edge, {"edge", "稜"}},
                                                                {Feature::vertex, {"vertex", "頂點"}}}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Point place = legend + 0.38 * size * static_cast<double>(i) * view.right();
    scene.sphere({place, 0.035 * size}, colour_of(names[i].first), 1, 2, 9);
    scene.label(program.say(names[i].second), place, 2.4, 0, colour::ink, Align::left);
  }
  finish(program.studio(), "bunny", scene);
}

// The sweep of this run.
void draw_sweep(const Studio& studio, const Environment& environment, const Moving<Sphere>& moving,
                const std::optional<Contact>& contact) {
  const View view{66, 32};
  const auto& [start, r] = moving.shape;
  const Point end = start + (contact ? contact->time : 1.0) * moving.displacement;
  figure::Scene scene(view);
  scene.mesh(environment.mesh(), {colour::sky, 1, true}, false);
  if (environment.mesh().size() < 200) draw_ridges(scene, environment, view, 1);
  scene.sphere({start, r}, colour::amber, 1, 2);
  scene.sphere({end, r}, colour::amber, 0.55, 2);
  scene.arrow(start, end, {colour::red, 2.4}, 3);
  scene.label("{/:Italic S}_0", start + r * view.up(), 0, 0.8);
  if (contact) {
    scene.arrow(contact->point(), contact->point() + 1.9 * r * contact->normal, {colour::ink, 2.0}, 3);
    scene.dot(contact->point());
    scene.label("{/:Italic C}", contact->point(), -1.0, 0.2);
    scene.label("{/:Bold N}", contact->point() + 1.9 * r * contact->normal, 0.9, -0.6);
  }
  scene.dot(start);
  finish(studio, "sweep", scene);
}

}  // namespace

void draw_general_sphere_figures(const program::Program& program, const Environment& environment,
                                 const Moving<Sphere>& moving, const std::optional<Contact>& contact) {
  const Studio& studio = program.studio();
  draw_moved_out(studio);
  draw_face_first(studio);
  draw_valley(studio);
  draw_jar(studio);
  draw_printed_cylinder(program);
  draw_order(program);
  draw_minkowski_sum(studio);
  draw_ray(studio);
  draw_bunny(program);
  jaw::draw(program);
  draw_sweep(studio, environment, moving, contact);
}
