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
  return {{720, 520}, 0.105, 0.975, 0.135, 0.91, {Eigen::Vector2d(-1, -5), Eigen::Vector2d(15, top)}};
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
      << "set ylabel \"" << program.say({"distance", "距離"}) << "\" offset 0.5, 0\n"
      << "set xlabel \"" << program.say({"time", "時間"}) << "\" offset 0, 0.4\n"
      << "set grid\nset border 15\nset xtics 5\nset ytics 5\n"
      << "set key top right box lc rgb PALE width 1 height 0.6 opaque fillcolor rgb PAPER samplen 2.2\n"
      << "obstacle = \"" << program.say({"obstacle", "障礙物"}) << "\"\n"
      << "path = \"" << program.say({"trajectory", "軌跡"}) << "\"\n"
      << "BALL_X = " << 2 * ball.x() << "\nBALL_Y = " << 2 * ball.y() << "\n";
}

constexpr const char* obstacle_clause =
    "$obstacle using 1:2 with filledcurves closed fc rgb YELLOW fs solid border lc rgb INK lw 0.8 title "
    "obstacle";

// The arrow that the paper's reader sets with the mouse: at the right of the rebound, pointing at it.
void write_arrow(std::ostream& out, const Flight& flight) {
  double time = 0.3 * last_shown(flight, 8);
  if (flight.impacts.size() > 1 && !flight.apexes.empty())
    time = 0.7 * flight.apexes.back().time + 0.3 * flight.impacts[1].time;
  if (!(time > 0 && time < 10)) time = 1;
  const Eigen::Vector2d tip = moment_at(flight, time).at + Eigen::Vector2d(0.14, 0.1);
  out << "set arrow 1 from " << tip.x() + 1.25 << "," << tip.y() << " to " << tip.x() << "," << tip.y()
      << " head filled size screen 0.02,18,60 front lc rgb INK lw 1.6\n"
      << "set label 1 path at " << tip.x() + 1.45 << "," << tip.y() << " left front\n";
}

Table balls(const std::vector<Moment>& list) { return rows(list); }

// What moves in a gif: the path as far as the ball has come, or all of it, and the ball.
void write_gif(Figure& figure, const Flight& flight, const Diagram& diagram, bool path_first,
               const std::string& extra) {
  Table frames;
  for (int k = 0; k * frame_time < played + frame_time / 2; ++k)
    frames.push_back(rows({moment_at(flight, k * frame_time)}).front());
  figure.data("frames", frames, 5);
  figure.data("path", path_of(flight, diagram, shown), 6);
  std::ostream& out = figure.script();
  const std::string moving = path_first
                                 ? "$path using 1:2 with lines lc rgb RED lw 1.8 notitle"
                                 : "$frames every ::0::k using 1:2 with lines lc rgb RED lw 1.8 notitle";
  out << "if (format eq \"gif\") {\n  do for [k = 0:" << frames.size() - 1 << "] {\n"
      << extra << "    plot " << obstacle_clause << ", \\\n     " << moving
      << ", \\\n     $frames every ::k::k using 1:2:(BALL_X):(BALL_Y) with ellipses fc rgb BLUE fs solid "
         "noborder "
         "notitle\n  }\n} else {\n  plot "
      << obstacle_clause
      << (path_first ? ", \\\n     $path using 1:2 with lines lc rgb RED lw 1.8 notitle" : "") << "\n}\n";
}

// Figure 13: the path is planned.
void draw_plan(const Program& program, const Flight& flight) {
  const Diagram diagram = axes(flight);
  Figure figure(program.studio(), "figure-13", diagram.size);
  write_stage(figure, program, diagram);
  write_arrow(figure.script(), flight);
  figure.data("path", path_of(flight, diagram, shown), 6);
  figure.data("ball", balls({moment_at(flight, 0)}));
  figure.script()
      << "plot " << obstacle_clause
      << ", \\\n     $path using 1:2 with lines lc rgb RED lw 2 notitle, \\\n"
         "     $ball using 1:2:(BALL_X):(BALL_Y) with ellipses fc rgb BLUE fs solid noborder notitle\n";
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
  figure.data("ball", balls({moment_at(flight, end)}));
  std::ostream& out = figure.script();
  const std::size_t hits = std::min<std::size_t>(2, flight.impacts.size());
  for (std::size_t i = 0; i < hits; ++i) {
    const double x = flight.impacts[i].time, y = i == 0 ? 4.6 : 8.2;
    if (!(x < 10)) continue;
    out << "set arrow " << i + 1 << " from " << x + 0.75 << "," << y << " to " << x + 0.1 << ",0.5"
        << " head filled size screen 0.02,18,60 front lc rgb INK lw 1.6\n"
        << "set label " << i + 1 << " \"" << hit_words(program, i) << "\" at " << x + 0.9 << "," << y + 0.3
        << " left front\n";
  }
  out << "plot " << obstacle_clause
      << ", \\\n     $path using 1:2 with lines lc rgb RED lw 2 title path, \\\n"
         "     $tested using 1:2 with points pt 7 ps 0.45 lc rgb BLUE title tested, \\\n"
         "     $ball using 1:2:(BALL_X):(BALL_Y) with ellipses fc rgb BLUE fs solid noborder notitle\n";
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
  figure.data("ball", balls({list.back()}));
  figure.script()
      << "plot " << obstacle_clause
      << ", \\\n     $path using 1:2 with lines lc rgb RED lw 1.6 notitle, \\\n"
         "     $stamps using 1:2:(BALL_X):(BALL_Y) with ellipses fc rgb fade(BLUE,0.28) fs solid border "
         "lc rgb BLUE lw 0.7 notitle, \\\n"
         "     $ball using 1:2:(BALL_X):(BALL_Y) with ellipses fc rgb BLUE fs solid noborder notitle\n";
  figure.draw();
}

// Programs 1 to 3 as they run. The first draws its path behind the ball, the second has it before and calls the hits,
// the third leaves the ball's image at equal steps of time.
void animate(const Program& program, const Flight& flight, int number) {
  const Diagram diagram = axes(flight);
  const std::string name = "figure-" + std::to_string(number) + "-animated";
  const bool chinese = program.studio().chinese;
  Figure figure(svg_only(program.studio()), name, diagram.size);
  figure.script() << gif_terminal(name, diagram.size, 4, chinese);
  write_stage(figure, program, diagram);
  Animation animation(diagram, played, played);
  const std::vector<Moment> list = moments(flight, played);
  std::string extra;
  if (number == 13) animation.trace(list, colour::red, 2);
  if (number == 14)
    for (std::size_t i = 0; i < std::min<std::size_t>(2, flight.impacts.size()); ++i) {
      const double from = flight.impacts[i].time,
                   until = i == 0 && flight.impacts.size() > 1 ? flight.impacts[1].time : played;
      if (!(from < played)) break;
      animation.text(hit_words(program, i), {5.2, 12}, from, until, colour::ink, chinese);
      extra += "    if (k * " + std::to_string(frame_time) + " >= " + std::to_string(from) +
               ") {set label 1 \"" + hit_words(program, i) + "\" at 5.2, 12 left}\n";
    }
  if (number == 15) {
    figure.data("stamps", rows(stamps(flight)), 6);
    for (const Moment& stamp : stamps(flight))
      if (stamp.time < played) animation.stamp(stamp, radius, colour::blue, 0.28);
  }
  animation.ball(list, radius, colour::blue);
  write_gif(figure, flight, diagram, number == 14, extra);
  draw_animated(program.studio(), name, figure, animation);
}

}  // namespace

void draw_paper_figures(const Program& program, const Flight& flight) {
  draw_plan(program, flight);
  draw_check(program, flight);
  draw_fall(program, flight);
  for (const int number : {13, 14, 15}) animate(program, flight, number);
}

}  // namespace tween_bounce

void draw_tween_bounce_figures(const Program& program, const tween_bounce::Flight& flight,
                               const tween_bounce::Flight& printed, const tween_bounce::Flight& physical) {
  tween_bounce::draw_paper_figures(program, flight);
  tween_bounce::draw_bounces(program, printed, physical);
  tween_bounce::draw_tweens(program);
}
