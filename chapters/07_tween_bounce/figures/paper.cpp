#include <algorithm>
#include <cmath>

#include "figures.hpp"
#include "first_contact/figure/animation.hpp"

using namespace first_contact;
using namespace first_contact::figure;
using program::Program;
namespace colour = first_contact::figure::colour;

namespace tween_bounce {

namespace {

constexpr double shown = 15;         // until when the flight is drawn, as in the paper
constexpr double played = 6;         // until when it is played, in its own time
constexpr double frame_time = 0.04;  // 25 pictures a second
constexpr double radius = 1;         // the ball rests on the obstacle, whose top is at -1, when y = 0

// The paper's axes; they grow with a flight that goes higher.
Diagram axes(const Flight& flight) {
  const double highest = *std::max_element(flight.y.begin(), flight.y.end());
  const double top = highest <= 29 ? 30 : 5 * std::ceil((highest + 1) / 5);
  return {{720, 530}, 0.115, 0.965, 0.15, 0.9, {Eigen::Vector2d(-1, -5), Eigen::Vector2d(15, top)}};
}

std::vector<Moment> moments(const Flight& flight, double until) {
  std::vector<Moment> list;
  for (std::size_t i = 0; i < flight.t.size() && flight.t[i] <= until; ++i)
    list.push_back({flight.t[i], {flight.t[i], flight.y[i]}});
  return list;
}

Moment moment_at(const Flight& flight, double time) { return {time, {time, height_at(flight, time)}}; }

Table rows(const std::vector<Moment>& list) {
  Table table;
  for (const Moment& moment : list) table.push_back({moment.at.x(), moment.at.y()});
  return table;
}

// The path as a reader sees it: corners kept, and nothing closer than a tenth of a point.
Table path_of(const Flight& flight, const Diagram& diagram, double until) {
  return rows(sparse(moments(flight, until), 0.1 / diagram.unit_y()));
}

double last_shown(const Flight& flight, double until) { return std::min(flight.t.back(), until); }

// Everything but ball and path: title, axes, grid, legend and obstacle, with the paper's words.
void write_stage(Figure& figure, const Program& program, const Diagram& diagram) {
  std::ostream& out = figure.script();
  const Eigen::Vector2d ball = {radius * diagram.unit_y() * diagram.range.sizes().x() /
                                    (diagram.size.width * (diagram.right - diagram.left)),
                                radius};
  figure.data("obstacle", {{-0.1, -1}, {20, -1}, {20, -1.3}, {-0.1, -1.3}, {-0.1, -1}});
  out << diagram.commands()
      << "set title \"Rigid ball object collides an obstacle in 2D space.\" offset 0, -0.3\n"
      << "set label 21 \"" << program.say({"distance", "距離"})
      << "\" at screen 0.03, 0.525 center rotate by 90 tc rgb INK\n"
      << "set label 22 \"" << program.say({"time", "時間"}) << "\" at screen 0.54, 0.045 center tc rgb INK\n"
      << "set grid\nset border 15\nset xtics 5 font \",15\"\nset ytics "
      << (diagram.range.max().y() <= 60 ? "5" : "autofreq") << " font \",15\"\n"
      << "set key top right box lc rgb PALE width -1 height 0.6 opaque fillcolor rgb PAPER samplen 2.2\n"
      << "obstacle = \"" << program.say({"obstacle", "障礙物"}) << "\"\n"
      << "path = \"" << program.say({"trajectory", "軌跡"}) << "\"\n"
      << "BALL_X = " << 2 * ball.x() << "\nBALL_Y = " << 2 * ball.y() << "\n";
}

constexpr const char* obstacle_clause =
    "$obstacle using 1:2 with filledcurves closed fc rgb YELLOW fs solid border lc rgb INK lw 0.8 title "
    "obstacle";

// The plot clauses of what all three figures show, from the data blocks of these names.
const std::string path_clause = ", \\\n     $path using 1:2 with lines lc rgb RED lw 2";
const std::string ball_style = ":(BALL_X):(BALL_Y) with ellipses fc rgb BLUE fs solid noborder notitle";
const std::string ball_clause = ", \\\n     $ball using 1:2" + ball_style;
const std::string stamp_style =
    ":(BALL_X):(BALL_Y) with ellipses fc rgb fade(BLUE,0.28) fs solid border lc rgb BLUE lw 0.7 notitle";

// A gif knows no half-transparent colours.
const std::string pale_stamp_style =
    ":(BALL_X):(BALL_Y) with ellipses fc rgb FLOOR fs solid border lc rgb BLUE lw 0.7 notitle";

// The arrow that the paper's reader sets with the mouse: at the right of the rebound, pointing at it.
void write_arrow(std::ostream& out, const Flight& flight) {
  double time = 0.3 * last_shown(flight, 8);
  if (flight.impacts.size() > 1 && !flight.apexes.empty())
    time = 0.7 * flight.apexes.back().time + 0.3 * flight.impacts[1].time;
  if (!(time > 0 && time < 10)) time = 1;
  const Eigen::Vector2d tip = moment_at(flight, time).at + Eigen::Vector2d(0.14, 0.1);
  out << "set arrow 1 from " << tip.x() + 1.25 << "," << tip.y() << " to " << tip.x() << "," << tip.y()
      << " head filled size screen 0.02,18,60 front lc rgb INK lw 1.6\n"
      << "set label 1 path at " << tip.x() + 1.45 << "," << tip.y() << " left front tc rgb INK\n";
}

// What the pictures of a gif show besides stage and ball.
struct Moving {
  std::string before;   // commands of a picture's own
  std::string drawn;    // plot clauses of a picture; its time is T
  std::string resting;  // plot clauses of what rests, for the svg
};

// The corners of the path and the places at every picture's time.
Table trail_of(const Flight& flight, const Diagram& diagram) {
  Table trail = path_of(flight, diagram, played);
  for (int k = 0; k * frame_time < played; ++k) trail.push_back(rows({moment_at(flight, k * frame_time)})[0]);
  std::sort(trail.begin(), trail.end());
  return trail;
}

// The script of an animation: as gif picture by picture, else what rests.
void write_pictures(Figure& figure, const Flight& flight, const Moving& moving) {
  Table frames;
  for (int k = 0; k * frame_time < played; ++k)
    frames.push_back(rows({moment_at(flight, k * frame_time)})[0]);
  figure.data("frames", frames, 6);
  figure.script() << "if (format eq \"gif\") {\n  do for [k = 0:" << frames.size() - 1
                  << "] {\n    T = " << frame_time << " * k + 1e-9\n"
                  << moving.before << "    plot " << obstacle_clause << moving.drawn
                  << ", \\\n     $frames every ::k::k using 1:2" << ball_style << "\n  }\n} else {\n  plot "
                  << obstacle_clause << moving.resting << "\n}\n";
}

// Figure 13: the path is planned.
void draw_plan(const Program& program, const Flight& flight) {
  const Diagram diagram = axes(flight);
  Figure figure(program.studio(), "figure-13", diagram.size);
  write_stage(figure, program, diagram);
  write_arrow(figure.script(), flight);
  figure.data("path", path_of(flight, diagram, shown), 6);
  figure.data("ball", rows({moment_at(flight, 0)}));
  figure.script() << "plot " << obstacle_clause << path_clause << " notitle" << ball_clause << "\n";
  figure.draw();
}

// The words of program 2 at its first two hits.
std::string hit_words(const Program& program, std::size_t i) {
  const std::string n = std::to_string(i + 1);
  return program.say({"hit " + n + " on the ground", "第" + n + "次碰撞地面"});
}

// Figure 14: the ball follows the planned path.
void draw_check(const Program& program, const Flight& flight) {
  const Diagram diagram = axes(flight);
  std::vector<Moment> tested;
  const double step = 0.1, end = last_shown(flight, 5);
  for (int i = 0; i * step <= end; ++i) tested.push_back(moment_at(flight, i * step));
  Figure figure(program.studio(), "figure-14", diagram.size);
  write_stage(figure, program, diagram);
  figure.data("path", path_of(flight, diagram, shown), 6);
  figure.data("tested", rows(tested), 6);
  figure.data("ball", rows({moment_at(flight, end)}));
  std::ostream& out = figure.script();
  const std::size_t hits = std::min<std::size_t>(2, flight.impacts.size());
  // The words of the first hit are below the obstacle, those of the second to its right.
  const Eigen::Vector2d words[]{{1.1, -3.4}, {1.3, 3.6}};
  for (std::size_t i = 0; i < hits && flight.impacts[i].time < 9; ++i) {
    const double x = flight.impacts[i].time;
    const Eigen::Vector2d at = words[i] + Eigen::Vector2d(x, 0);
    out << "set arrow " << i + 1 << " from " << at.x() - 0.15 << "," << at.y() << " to " << x + 0.1 << ","
        << (i == 0 ? -0.5 : 0.5) << " head filled size screen 0.02,18,60 front lc rgb INK lw 1.6\n"
        << "set label " << i + 1 << " \"" << hit_words(program, i) << "\" at " << at.x() << "," << at.y()
        << " left front tc rgb INK\n";
  }
  out << "tested = \"" << program.say({"tested", "測試點"}) << "\"\nplot " << obstacle_clause << path_clause
      << " title path, \\\n     $tested using 1:2 with points pt 7 ps 0.4 lc rgb BLUE title tested"
      << ball_clause << "\n";
  figure.draw();
}

// The ball at equal steps of time, until it stays on the floor.
std::vector<Moment> stamps(const Flight& flight) {
  std::vector<Moment> list;
  const double end = flight.impacts.size() > 1 ? flight.impacts[1].time : last_shown(flight, 5);
  for (int i = 0; i * 0.1 <= std::min(end, 12.0); ++i) list.push_back(moment_at(flight, i * 0.1));
  return list;
}

// Figure 15: fast down, slow up.
void draw_fall(const Program& program, const Flight& flight) {
  const Diagram diagram = axes(flight);
  Figure figure(program.studio(), "figure-15", diagram.size);
  write_stage(figure, program, diagram);
  const std::vector<Moment> list = stamps(flight);
  figure.data("path", path_of(flight, diagram, shown), 6);
  figure.data("stamps", rows(list), 6);
  figure.data("ball", rows({list.back()}));
  if (flight.impacts.size() > 1 && flight.impacts[1].time < 9) {
    const double fall = 0.2 * flight.impacts[0].time,
                 rise = 0.25 * flight.impacts[0].time + 0.75 * flight.impacts[1].time;
    figure.script() << "set label 1 \"" << program.say({"fast", "快"}) << "\" at " << fall + 0.45 << ","
                    << height_at(flight, fall) + 0.6 << " left tc rgb INK\nset label 2 \""
                    << program.say({"slow", "慢"}) << "\" at " << rise + 0.45 << ","
                    << height_at(flight, rise) + 0.8 << " left tc rgb INK\n";
  }
  figure.script() << "plot " << obstacle_clause << path_clause << " notitle, \\\n     $stamps using 1:2"
                  << stamp_style << ball_clause << "\n";
  figure.draw();
}

// Program 1 as it runs: the path is drawn behind the ball.
void animate_plan(Figure& figure, const Flight& flight, Animation& animation, Moving& moving) {
  figure.data("trail", trail_of(flight, axes(flight)), 6);
  animation.trace(moments(flight, played), colour::red, 2);
  moving.drawn = ", \\\n     $trail using ($1 <= T ? $1 : NaN):2 with lines lc rgb RED lw 2 notitle";
}

// Program 2: the path is there before, and the first two hits are called.
void animate_check(const Program& program, Figure& figure, const Flight& flight, Animation& animation,
                   Moving& moving) {
  const Diagram diagram = axes(flight);
  figure.data("path", path_of(flight, diagram, shown), 6);
  moving.drawn = moving.resting = path_clause + " notitle";
  const std::size_t hits = std::min<std::size_t>(2, flight.impacts.size());
  for (std::size_t i = 0; i < hits && flight.impacts[i].time < played; ++i) {
    const double from = flight.impacts[i].time, until = i + 1 < hits ? flight.impacts[i + 1].time : played;
    animation.text(hit_words(program, i), {5.2, 12}, from, until, colour::ink, program.studio().chinese);
    moving.before += "    if (T >= " + program::readable(from) + ") { set label 1 \"" +
                     hit_words(program, i) + "\" at 5.2, 12 left tc rgb INK }\n";
  }
}

// Program 3: the ball leaves its image at equal steps of time.
void animate_fall(Figure& figure, const Flight& flight, Animation& animation, Moving& moving) {
  figure.data("stamps", rows(stamps(flight)), 6);
  moving.drawn = ", \\\n     $stamps using ($1 <= T ? $1 : NaN):2" + pale_stamp_style;
  for (const Moment& stamp : stamps(flight))
    if (stamp.time < played) animation.stamp(stamp, radius, colour::blue, 0.28);
}

void animate(const Program& program, const Flight& flight, int number) {
  const Diagram diagram = axes(flight);
  const std::string name = "figure-" + std::to_string(number) + "-animated";
  Figure figure(svg_only(program.studio()), name, diagram.size);
  figure.script() << gif_terminal(name, diagram.size, 4, program.studio().chinese);
  write_stage(figure, program, diagram);
  figure.script() << "if (format eq \"gif\") { set xtics font \",12\"; set ytics font \",12\" }\n";
  Animation animation(diagram, played, played);
  Moving moving;
  if (number == 13) animate_plan(figure, flight, animation, moving);
  if (number == 14) animate_check(program, figure, flight, animation, moving);
  if (number == 15) animate_fall(figure, flight, animation, moving);
  animation.ball(moments(flight, played), radius, colour::blue);
  write_pictures(figure, flight, moving);
  draw_animated(program.studio(), figure, animation);
}

}  // namespace

void draw_paper_figures(const Program& program, const Flight& flight) {
  draw_plan(program, flight);
  draw_check(program, flight);
  draw_fall(program, flight);
  for (const int number : {13, 14, 15}) animate(program, flight, number);
}

}  // namespace tween_bounce
