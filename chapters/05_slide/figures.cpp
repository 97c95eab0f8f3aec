#include "figures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "first_contact/figure/scene.hpp"
#include "first_contact/mesh_io/mesh_file.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "first_contact/sweep/sphere_plane.hpp"
#include "jitter.hpp"
#include "places.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

namespace {

const Pen wall_edge{colour::blue, 1.2};
const Pen offset_edge{colour::grey, 1.2, true};
const Pen way{colour::green, 2.4};
const Pen undone{colour::grey, 1.6, true};
const View front{90, 0};  // from the side

// The sphere's outline where it would have been.
void add_ghost(figure::Scene& scene, const Sphere& ball, const View& view) {
  std::vector<Point> outline;
  for (int degrees = 0; degrees <= 360; degrees += 4) {
    const double angle = degrees * std::numbers::pi / 180;
    outline.emplace_back(ball.center +
                         ball.radius * (std::cos(angle) * view.right() + std::sin(angle) * view.up()));
  }
  scene.line(outline, undone, 1);
}

void add_shadow(figure::Scene& scene, const Sphere& ball, double opacity = 1) {
  scene.disc({ball.center.x(), ball.center.y(), 0}, {0, 0, 1}, 0.85 * ball.radius, {colour::shadow, opacity},
             -2);
}

// Figure 10: on its way from P1 to P2 the ball meets the wall at Q; its new position is P3.
void draw_projection(const Studio& studio) {
  const ::Scene paper;
  const auto ball = paper.ball();
  const auto contact = *sweep(ball, paper.environment());
  const Point &p1 = paper.from, &p2 = paper.to;
  const Point q = p1 + contact.time * ball.displacement, p3 = slide_target(p2, q, contact.normal);
  const double r = paper.radius;
  const View view{72, 20};

  figure::Scene scene(view, 0.03);
  scene.patch(ground[0].middle, ground[0].u, ground[0].v, {colour::floor, 1, false, wall_edge}, -3);
  add_shadow(scene, {p1, r}, 0.6);
  add_shadow(scene, {q, r});
  add_shadow(scene, {p3, r});
  add_ghost(scene, {p2, r}, view);
  scene.sphere({p1, r});
  scene.sphere({q, r}, colour::amber, 0.4);
  scene.sphere({p3, r}, colour::amber, 0.6);
  scene.line({q, p2}, undone, 2);
  scene.line({p2, p3}, undone, 2);
  scene.arrow(p1, q);
  scene.arrow(q, p3, way);
  scene.arrow(q, q + Vector(0, 0, 1.1), {colour::ink, 2.4});
  for (const Point& dot : {p1, q, p2, p3}) scene.dot(dot);
  scene.label("{/:Italic P}_1", p1 - r * view.right(), -0.6, 0, colour::ink, Align::right);
  scene.label("{/:Italic P}_2", p2, 1.2, -0.2);
  scene.label("{/:Italic P}_3", p3, 1.2, 0.4);
  scene.label("{/:Italic Q}", q, -1.0, -0.6);
  scene.label("{/:Bold N}", q + Vector(0, 0, 1.1), 1.2, -0.2);
  Figure figure(studio, "figure-10", scene.size());
  scene.draw(figure);
  figure.draw();
}

// One half of the next figure, seen from the side: where the ball ends, with Q as the formula is given it.
void add_side_view(figure::Scene& scene, double x, const Point& q, const Colour& tone,
                   const std::string& title) {
  const Vector shift(x, 0, 0);
  const Point centre = Point(-0.5, 0, 0.5) + shift, p2 = Point(0.9, 0, -0.375) + shift, given = q + shift;
  const Point p3 = slide_target(p2, given, {0, 0, 1});
  scene.polygon({Point(-1.25, 0, 0) + shift, Point(1.6, 0, 0) + shift, Point(1.6, 0, -0.75) + shift,
                 Point(-1.25, 0, -0.75) + shift},
                {colour::floor}, -3);
  scene.line({Point(-1.25, 0, 0) + shift, Point(1.6, 0, 0) + shift}, {colour::blue, 1.6}, -2);
  scene.sphere({centre, 0.5}, colour::amber, 0.35);
  scene.sphere({p3, 0.5}, tone, 0.6);
  scene.line({given, p2, p3}, undone, 1);
  scene.arrow(given, p3, {tone, 2.4});
  for (const Point& dot : {given, p2, p3}) scene.dot(dot);
  scene.label("{/:Italic Q}", given, -0.9, 0.5);
  scene.label("{/:Italic P}_2", p2, 1.2, -0.1);
  scene.label("{/:Italic P}_3", p3, 0.6, 0.8);
  scene.label(title, Point(0.175, 0, 1.2) + shift, 0, 0, tone);
}

// The same motion twice: Q as the touched point, and as the centre.
void draw_half_sunk(const program::Program& program) {
  figure::Scene scene(front, 0.03);
  add_side_view(scene, 0, {-0.5, 0, 0}, colour::pink,
                program.say({"{/:Italic Q} on the surface", "{/:Italic Q} 為碰撞點"}));
  add_side_view(scene, 3.3, {-0.5, 0, 0.5}, colour::green,
                program.say({"{/:Italic Q} the centre", "{/:Italic Q} 為球心"}));
  Figure figure(program.studio(), "half-sunk", scene.size());
  scene.draw(figure);
  figure.draw();
}

// A ball in a room: after the first wall alone it would end beyond the second, at P3; the loop ends at P.
void draw_room(const Studio& studio, const char* name, const std::vector<Rectangle>& room,
               const Moving<Sphere>& ball) {
  const Slide path = slide(ball, Environment(walls(room)));
  const double r = ball.shape.radius;
  const Point p2 = ball.shape.center + ball.displacement;
  const Point p3 = slide_target(p2, path.positions[1], path.contacts[0].normal);
  const View view{66, -26};

  figure::Scene scene(view, 0.03);
  for (std::size_t i = 0; i < room.size(); ++i)
    scene.patch(room[i].middle, room[i].u, room[i].v,
                {i == 0 ? colour::floor : colour::mist, 1, false, wall_edge}, -4);
  add_shadow(scene, ball.shape, 0.6);
  for (std::size_t i = 1; i < path.positions.size(); ++i)
    add_shadow(scene, {path.positions[i], r}, i + 1 < path.positions.size() ? 0.6 : 1);
  add_ghost(scene, {p3, r}, view);
  scene.line({path.positions[1], p3}, undone, 1);
  scene.sphere(ball.shape);
  scene.sphere({path.end(), r}, colour::amber, 0.6, 1);
  scene.arrow(path.positions[0], path.positions[1]);
  for (std::size_t i = 1; i + 1 < path.positions.size(); ++i) {
    scene.arrow(path.positions[i], path.positions[i + 1], way, 3);
    scene.dot(path.positions[i]);
    scene.label("{/:Italic Q}_" + std::to_string(i), path.positions[i], 1.4, -0.5);
  }
  for (const Point& dot : {path.positions[0], path.end(), p3}) scene.dot(dot);
  scene.label("{/:Italic P}_1", path.positions[0] - r * view.right(), -0.6, 0, colour::ink, Align::right);
  scene.label("{/:Italic P}_3", p3, 1.2, 0.4, colour::grey);
  scene.label("{/:Italic P}", path.end(), 0.3, 0.9);
  Figure figure(studio, name, scene.size());
  scene.draw(figure);
  figure.draw();
}

// At a shallow angle a gap that is laid back along the path is next to none; along the normal it is what it
// is.
void draw_gap(const program::Program& program) {
  const double angle = 14 * std::numbers::pi / 180, gap = 0.6;
  const Vector along(std::cos(angle), 0, -std::sin(angle));
  const Point q(0, 0, 0), before = q - gap * along, kept = q - gap / std::sin(angle) * along;
  const Vector beside = 0.1 * Vector(std::sin(angle), 0, std::cos(angle));
  const auto foot = [](const Point& p) { return Point(p.x(), 0, 0); };
  std::vector<Point> arc;
  for (double part = 0; part <= 1; part += 0.125)
    arc.emplace_back(-1.5 * std::cos(part * angle), 0, 1.5 * std::sin(part * angle));

  figure::Scene scene(front, 0.03);
  scene.line({{-4.1, 0, 0}, {1.1, 0, 0}}, offset_edge, 0);
  scene.polygon({{-4.1, 0, -0.75}, {1.1, 0, -0.75}, {1.1, 0, -1}, {-4.1, 0, -1}}, {colour::floor}, -3);
  scene.line({{-4.1, 0, -0.75}, {1.1, 0, -0.75}}, {colour::blue, 1.6}, -2);
  scene.arrow(q - 4.2 * along, q);
  scene.line(arc, {colour::grey, 1.2});
  scene.line({before + beside, q + beside}, {colour::pink, 3}, 3);
  scene.line({before, foot(before)}, {colour::pink, 3}, 3);
  scene.line({kept, foot(kept)}, {colour::green, 3}, 3);
  for (const Point& dot : {q, before, kept}) scene.dot(dot);
  scene.label("{/:Italic Q}", q, 0.6, -0.9);
  scene.label("{/:Italic θ}", arc[4], -0.9, 0, colour::grey);
  scene.label("{/:Italic g}", 0.5 * (before + q), 0.6, 1.2, colour::pink);
  scene.label("{/:Italic g} sin {/:Italic θ}", foot(before), 0, -0.9, colour::pink);
  scene.label("{/:Italic g}", 0.5 * (kept + foot(kept)), -0.9, 0, colour::green);
  scene.label(program.say({"along the normal", "沿法向量"}), foot(kept), 0, -0.9, colour::green);
  scene.label(program.say({"along the path", "沿路徑"}), before, 3.5, 2.5, colour::pink);
  scene.label("{/:Italic E}′", {1.1, 0, 0}, -0.4, 0.7, colour::grey, Align::right);
  scene.label("{/:Italic E}", {1.1, 0, -0.75}, -0.4, 0.7, colour::blue, Align::right);
  Figure figure(program.studio(), "gap", scene.size());
  scene.draw(figure);
  figure.draw();
}

// Frame after frame with the same wish, a ball slides over the bunny's back, its cheek and its chest.
void draw_bunny(const Studio& studio) {
  const Environment bunny(read_mesh(places::meshes + std::string("/bunny.off")));
  const auto& [ball, wish] = over_the_bunny;
  const Frames run = slide_frames(over_the_bunny, bunny, 150);
  figure::Scene scene({72, 24}, 0.03);
  scene.mesh(bunny.mesh(), {colour::floor, 1, true}, true, -1);
  scene.sphere(ball);
  scene.arrow(ball.center, ball.center + 16 * wish, {colour::red, 2.4}, 3);
  for (const std::size_t frame : {86U, 150U})
    scene.sphere({run.positions[frame], ball.radius}, colour::amber, 0.6, 1);
  scene.line(run.positions, {colour::green, 2.4}, 2);
  Figure figure(studio, "bunny", scene.size());
  scene.draw(figure);
  figure.draw();
}

// Pressed into a corner of 120 degrees: wall after wall the ball jitters, with both walls it stands.
void draw_jitter(const program::Program& program) {
  const int frames = 40;
  const Environment corner(wide_corner);
  const Frames naive = wall_after_wall_frames(into_wide_corner, corner, frames);
  const Frames both = slide_frames(into_wide_corner, corner, frames);
  const auto rows = [](const Frames& run) {
    Table table;
    for (std::size_t i = 0; i < run.positions.size(); ++i)
      table.push_back({static_cast<double>(i), run.positions[i].y()});
    return table;
  };
  Figure figure(program.studio(), "jitter", {720, 300});
  figure.data("naive", rows(naive), 5);
  figure.data("both", rows(both), 5);
  figure.script()
      << "set lmargin at screen 0.095\nset rmargin at screen 0.975\nset bmargin at screen 0.25\n"
      << "set tmargin at screen 0.86\nset grid\nunset key\nset xrange [0:" << frames
      << "]\nset yrange [-0.15:0.3]\nset ytics 0.1\nset xtics font \",15\"\nset ytics font \",15\"\n"
      << "set label 1 \"" << program.say({"beside the corner", "偏離角落的距離"})
      << "\" at screen 0.02, 0.93 left tc rgb INK\nset label 2 \"" << program.say({"frame", "影格"})
      << "\" at screen 0.535, 0.05 center tc rgb INK\nset label 3 \""
      << program.say({"one wall after the other", "逐牆投影"})
      << "\" at 24, 0.14 center tc rgb PINK\nset label 4 \""
      << program.say({"both walls at once", "兼顧兩牆"}) << "\" at 24, -0.105 center tc rgb GREEN\n"
      << "plot $naive with linespoints pt 7 ps 0.45 lc rgb PINK lw 1.6, $both with linespoints pt 7 ps "
         "0.45 lc rgb GREEN lw 2.2\n";
  figure.draw();
}

// A closed surface whose faces look outwards shows only those that face the eye.
bool closed_outwards(const Environment& environment) {
  const auto& edges = environment.topology().edges();
  double volume = 0;
  for (std::size_t i = 0; i < environment.mesh().size(); ++i) {
    const Triangle triangle = environment.mesh().triangle(i);
    volume += triangle.a.dot(triangle.b.cross(triangle.c));
  }
  return volume > 0 &&
         std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.side_count == 2; });
}

// The slide of this run.
void draw_run(const Studio& studio, const Environment& environment, const Moving<Sphere>& ball,
              const Slide& path) {
  figure::Scene scene({70, 24}, 0.04);
  Fill fill{colour::floor, 1, environment.mesh().size() > 2};  // a lone wall needs no light
  if (environment.mesh().size() <= 200) fill.outline = wall_edge;
  scene.mesh(environment.mesh(), fill, closed_outwards(environment), -1);
  scene.sphere(ball.shape);
  if (path.positions.size() > 1) scene.sphere({path.end(), ball.shape.radius}, colour::amber, 0.6, 1);
  for (std::size_t i = 1; i < path.positions.size(); ++i)
    scene.arrow(path.positions[i - 1], path.positions[i], i == 1 ? Pen{colour::red, 2.4} : way, 2);
  for (const Point& position : path.positions) scene.dot(position);
  for (const Contact& contact : path.contacts) scene.dot(contact.point(), colour::blue);
  Figure figure(studio, "slide", scene.size());
  scene.draw(figure);
  figure.draw();
}

}  // namespace

void draw_slide_figures(const program::Program& program, const Environment& environment,
                        const Moving<Sphere>& ball, const Slide& path) {
  draw_projection(program.studio());
  draw_half_sunk(program);
  draw_room(program.studio(), "crease", crease, into_crease);
  draw_room(program.studio(), "corner", corner, into_corner);
  draw_jitter(program);
  draw_gap(program);
  draw_bunny(program.studio());
  draw_run(program.studio(), environment, ball, path);
}
