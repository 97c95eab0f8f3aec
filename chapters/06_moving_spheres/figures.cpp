#include "figures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "far_away.hpp"
#include "first_contact/figure/scene.hpp"
#include "scene.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

namespace {

// The paper's two spheres move in one plane; seen at right angles to it, what touches also looks so.
const View front{90, 0};

Point at(const Moving<Sphere>& ball, double t) { return ball.shape.center + t * ball.displacement; }

// A sphere where it starts and, of glass, where it ends, with its velocity.
void add_motion(figure::Scene& scene, const Moving<Sphere>& ball, const Colour& colour) {
  scene.sphere({at(ball, 1), ball.shape.radius}, colour, 0.4, 0);
  scene.sphere(ball.shape, colour, 1, 1);
  scene.arrow(at(ball, 0), at(ball, 1));
  scene.dot(at(ball, 0));
  scene.dot(at(ball, 1));
}

// Figure 11: two spheres, each moving along a straight line with constant velocity.
void draw_motions(const Studio& studio) {
  const ::Scene paper;
  const auto p = paper.p(), q = paper.q();
  figure::Scene scene(front, 0.04);
  add_motion(scene, p, colour::amber);
  add_motion(scene, q, colour::sky);
  scene.label("{/:Italic P}_1", at(p, 0), -1.2, 0.4);
  scene.label("{/:Italic P}_2", at(p, 1), 1.2, 0.4);
  scene.label("{/:Italic Q}_1", at(q, 0), 1.3, 0.4);
  scene.label("{/:Italic Q}_2", at(q, 1), -1.3, 0.4);
  scene.label("{/:Bold V}_{/:Italic P}", at(p, 0.32), 0, 0.9, colour::red);
  scene.label("{/:Bold V}_{/:Italic Q}", at(q, 0.42), -1.5, 0.4, colour::red);
  Figure figure(studio, "figure-11", scene.size());
  scene.draw(figure);
  figure.draw();
}

// Figure 12: the point of contact C is on the line of the centres, r_P from P(t).
void draw_contact(const Studio& studio) {
  const ::Scene paper;
  const Meeting meeting(paper.p(), paper.q(), paper.when());
  const Vector n = -meeting.contact->normal, across(n.z(), 0, -n.x());
  const Point c = meeting.contact->point();
  figure::Scene scene(front, 0.05);
  scene.sphere({meeting.p, paper.rp}, colour::amber, 0.55);
  scene.sphere({meeting.q, paper.rq}, colour::sky, 0.55);
  scene.line({c - 0.8 * across, c + 0.8 * across}, {colour::grey, 1.2, true});
  scene.line({meeting.p, meeting.q}, {colour::grey, 1.6});
  scene.arrow(meeting.p, meeting.p + 0.7 * n, {colour::ink, 2.4}, 3);
  for (const Point& dot : {meeting.p, meeting.q, c}) scene.dot(dot);
  scene.label("{/:Italic P}({/:Italic t})", meeting.p, -1.3, -0.9);
  scene.label("{/:Italic Q}({/:Italic t})", meeting.q, 1.8, 0.3);
  scene.label("{/:Italic C}", c, -0.2, 1.1);
  scene.label("{/:Bold N}", meeting.p + 0.45 * n, -1.2, 0.3);
  scene.label("{/:Italic r_P}", meeting.p + 0.5 * paper.rp * n, 1.4, -0.4);
  scene.label("{/:Italic r_Q}", c + 0.5 * paper.rq * n, 1.4, -0.4);
  Figure figure(studio, "figure-12", scene.size(480));
  scene.draw(figure);
  figure.draw();
}

// A right angle's mark at `corner`, between two unit vectors.
void add_right_angle(figure::Scene& scene, const Point& corner, const Vector& u, const Vector& v,
                     double size) {
  scene.line({corner + size * u, corner + size * (u + v), corner + size * v}, {colour::grey, 1.2});
}

std::vector<Point> circle(double radius) {
  std::vector<Point> points;
  for (int degrees = 0; degrees < 360; degrees += 2) {
    const double angle = degrees * std::numbers::pi / 180;
    points.emplace_back(radius * std::cos(angle), 0, radius * std::sin(angle));
  }
  return points;
}

// The sweep of this run as seen from Q: P has become a point, Q has grown to the radius d, and the square
// root is half the chord. Drawn in the plane of w and u: x along u, z along the closest approach.
void draw_closest_approach(const Studio& studio, const Moving<Sphere>& p, const Moving<Sphere>& q) {
  const Vector w = p.shape.center - q.shape.center, u = p.displacement - q.displacement;
  const double d = p.shape.radius + q.shape.radius, speed = u.norm();
  const double miss = accurate_cross(w, u).norm() / speed, start = w.dot(u) / speed;
  const auto times = contact_interval(p, q);
  const auto on_path = [&](double x) { return Point(x, 0, miss); };
  const double last = std::max({start + speed, times ? start + times->end * speed + 0.3 * d : d, 1.2 * d});
  const double first = std::min(start, -1.2 * d);
  const Point origin(0, 0, 0);

  figure::Scene scene(front, 0.07);
  scene.polygon(circle(d), {colour::floor, 1, false, Pen{colour::blue, 1.4}}, -1);
  scene.line({on_path(first), on_path(last)}, {colour::grey, 1.2, true}, 0);
  scene.arrow(on_path(start), on_path(start + speed));
  scene.line({origin, on_path(0)}, {colour::ink, 1.8});
  scene.dot(origin, colour::blue);
  scene.dot(on_path(start));
  scene.label("{/:Italic Q}", origin, 0, -1.0, colour::blue);
  scene.label("{/:Italic P}", on_path(start), 0, -1.0);
  scene.label("{/:Bold u}", on_path(start + 0.25 * speed), 0, 0.9, colour::red);
  scene.label("|{/:Bold w} × {/:Bold u}| / |{/:Bold u}|", 0.45 * on_path(0), 0.6, 0, colour::ink,
              Align::left);
  if (times) {
    const Point enter = on_path(start + times->begin * speed), leave = on_path(start + times->end * speed);
    add_right_angle(scene, on_path(0), {-1, 0, 0}, {0, 0, -1}, 0.12 * d);
    scene.line({origin, enter}, {colour::blue, 1.8});
    scene.line({enter, on_path(0)}, {colour::green, 3.4}, 3);
    scene.dot(enter);
    scene.dot(leave);
    scene.label("{/:Italic d}", 0.5 * enter, -0.6, -0.8, colour::blue);
    scene.label("{/:Italic t}_1", enter, -0.8, 0.9);
    scene.label("{/:Italic t}_2", leave, 0.9, 0.9);
    scene.label("√{/:Italic D} / |{/:Bold u}|", 0.5 * (enter + on_path(0)), 0, 0.9, colour::green);
  }
  Figure figure(studio, "closest-approach", scene.size());
  scene.draw(figure);
  figure.draw();
}

// One curve of the measurements: errors as powers of ten, losses in per cent, and its name at the last point.
void add_curve(Figure& figure, const char* name, const std::vector<program::Accuracy>& results) {
  Table rows;
  for (const program::Accuracy& result : results)
    rows.push_back({std::log10(result.distance), std::log10(result.error), 100 * result.lost});
  figure.data(name, rows, 4);
}

// Two charts, one above the other: errors, and hits that are lost.
constexpr const char* far_away_script = R"(unset key
set grid
set xrange [0:10]
set xtics 0, 2 font ",14"
set lmargin at screen 0.115
set rmargin at screen 0.96
set multiplot
set tmargin at screen 0.925
set bmargin at screen 0.43
set yrange [-17:2]
set ytics -16, 4 font ",14"
set format y "10^{%.0f}"
set format x ""
set label 1 error at graph -0.08, 1.075 left font ",16" tc rgb INK
set label 2 printed_s at 2.7, -0.95 right font ",15" tc rgb PINK
set label 3 stable_s at 4.4, -6.5 right font ",15" tc rgb GREEN
set label 4 printed_d at 3.1, -8.6 right font ",15" tc rgb PINK
set label 5 stable_d at 6.3, -11.3 left font ",15" tc rgb GREEN
set arrow 1 from 0, 0 to 10, 0 nohead lc rgb GREY lw 1.2 dt (6,5)
plot $printed_single using 1:2 with lines lc rgb PINK lw 2.2 dt (8,5), \
 $stable_single using 1:2 with lines lc rgb GREEN lw 2.2 dt (8,5), \
 $printed_double using 1:2 with lines lc rgb PINK lw 2.2, \
 $stable_double using 1:2 with lines lc rgb GREEN lw 2.2
set tmargin at screen 0.335
set bmargin at screen 0.14
unset label
unset arrow 1
set yrange [-2:50]
set ytics 0, 20 font ",14"
set format y "%g"
set format x "10^{%.0f}"
set label 1 lost at graph -0.08, 1.15 left font ",16" tc rgb INK
set xlabel distance font ",16" offset 0, 0.3
plot $printed_single using 1:3 with lines lc rgb PINK lw 2.2 dt (8,5), \
 $printed_double using 1:3 with lines lc rgb PINK lw 2.2, \
 $stable_single using 1:3 with lines lc rgb GREEN lw 2.2 dt (8,5), \
 $stable_double using 1:3 with lines lc rgb GREEN lw 2.2
unset multiplot
)";

// Errors and losses against the distance: both formulas, in single and in double precision.
void draw_far_away(const program::Program& program) {
  Figure figure(program.studio(), "far-away", {720, 700});
  add_curve(figure, "printed_single", measure<float>(Formula::textbook));
  add_curve(figure, "printed_double", measure<double>(Formula::textbook));
  add_curve(figure, "stable_single", measure<float>(Formula::closest_approach));
  add_curve(figure, "stable_double", measure<double>(Formula::closest_approach));
  program.label(figure, "printed_s", {"printed, single", "論文所印，單精度"});
  program.label(figure, "printed_d", {"printed, double", "論文所印，雙精度"});
  program.label(figure, "stable_s", {"stable, single", "穩定形式，單精度"});
  program.label(figure, "stable_d", {"stable, double", "穩定形式，雙精度"});
  program.label(figure, "error",
                {"error of the contact, in {/:Italic d}", "碰撞位置的誤差（以 {/:Italic d} 計）"});
  program.label(figure, "lost", {"hits lost, %", "漏失的碰撞（%）"});
  program.label(figure, "distance",
                {"distance at the start, in {/:Italic d}", "出發時的距離（以 {/:Italic d} 計）"});
  figure.script() << far_away_script;
  figure.draw();
}

}  // namespace

void draw_moving_spheres_figures(const program::Program& program, const Moving<Sphere>& p,
                                 const Moving<Sphere>& q) {
  draw_motions(program.studio());
  draw_contact(program.studio());
  draw_distance(program, p, q);
  if (p.displacement != q.displacement) draw_closest_approach(program.studio(), p, q);
  draw_far_away(program);
  draw_growth(program);
}
