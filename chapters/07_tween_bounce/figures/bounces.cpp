#include <algorithm>
#include <cmath>

#include "figures.hpp"
#include "first_contact/figure/animation.hpp"
#include "stepped_bounce.hpp"

using namespace first_contact;
using namespace first_contact::figure;
using program::Program;

namespace tween_bounce {

namespace {

// The flight to within a hair's breadth: corners kept.
Table path_of(const Flight& flight, double until) {
  std::vector<Moment> list;
  for (std::size_t i = 0; i < flight.t.size() && flight.t[i] <= until; ++i)
    list.push_back({flight.t[i], {flight.t[i], flight.y[i]}});
  Table rows;
  for (const Moment& moment : sparse(list, 0.005)) rows.push_back({moment.at.x(), moment.at.y()});
  return rows;
}

// Every sample of a flight.
Table samples_of(const Flight& flight, double until) {
  Table rows;
  for (std::size_t i = 0; i < flight.t.size() && flight.t[i] <= until; ++i)
    rows.push_back({flight.t[i], flight.y[i]});
  return rows;
}

// Axes with their names: time below, and what is measured above on the left.
void write_axes(std::ostream& out, const Program& program, const program::Text& above,
                const program::Text& below) {
  out << "set lmargin at screen 0.08\nset rmargin at screen 0.965\nset bmargin at screen 0.175\n"
      << "set tmargin at screen 0.88\nset grid\nunset key\nset xtics font \",15\"\nset ytics font \",15\"\n"
      << "set label 21 \"" << program.say(above) << "\" at screen 0.02, 0.945 left tc rgb INK\n"
      << "set label 22 \"" << program.say(below) << "\" at screen 0.5225, 0.05 center tc rgb INK\n";
}

// The same throw as printed and as it is.
void draw_printed_and_physical(const Program& program, const Flight& printed, const Flight& physical) {
  const double end = std::clamp(physical.rest_time.value_or(12) * 1.12, 1.0, std::max(1.0, printed.t.back()));
  const auto higher = [](const Flight& flight) {
    return *std::max_element(flight.y.begin(), flight.y.end());
  };
  const double top = 1.12 * std::max({higher(printed), higher(physical), 1.0});
  Figure figure(program.studio(), "printed-and-physical", {720, 440});
  figure.data("printed", path_of(printed, end), 6);
  figure.data("physical", path_of(physical, end), 6);
  std::ostream& out = figure.script();
  write_axes(out, program, {"height", "高度"}, {"time", "時間"});
  out << "set xrange [0:" << end << "]\nset yrange [0:" << top << "]\n"
      << "set label 1 \"" << program.say({"as printed", "論文原式"})
      << "\" at graph 0.19, 0.42 left tc rgb PINK\n"
      << "set label 2 \"" << program.say({"solved at its impacts", "於碰撞時求解"})
      << "\" at graph 0.36, 0.84 left tc rgb GREEN\n";
  if (physical.rest_time && *physical.rest_time < end)
    out << "set arrow 3 from " << *physical.rest_time << ",0 to " << *physical.rest_time << "," << 0.55 * top
        << " nohead lc rgb GREY lw 1.2 dt (6,5)\nset label 3 \""
        << program.say({"rest, after infinitely\\nmany impacts", "靜止：此前碰撞\\n無窮多次"})
        << "\" at graph 0.998, 0.67 right tc rgb INK\n";
  out << "plot $physical using 1:2 with lines lc rgb GREEN lw 2.2, $printed using 1:2 with lines lc rgb PINK "
         "lw 2.2\n";
  figure.draw();
}

// The printed fall in larger and smaller steps: each finds the floor late in its own way, and rebounds to
// another height.
void draw_steps(const Program& program) {
  Figure figure(program.studio(), "steps", {720, 440});
  std::ostream& out = figure.script();
  write_axes(out, program, {"height", "高度"}, {"time", "時間"});
  out << "set xrange [0:5]\nset yrange [0:27]\nset ytics 5\n";
  const struct {
    const char* name;
    double dt;
    const char* pen;
  } runs[]{{"coarse", 0.2, "BLUE"}, {"middle", 0.05, "PINK"}, {"fine", 0.001, "INK"}};
  std::string plot = "plot ";
  double label_height = 24.5;
  for (const auto& [name, dt, pen] : runs) {
    PrintedBounce bounce;
    bounce.dt = dt;
    bounce.samples = static_cast<std::size_t>(std::lround(5 / dt)) + 1;
    const Flight flight = printed_flight(run(bounce));
    figure.data(name, dt > 0.01 ? samples_of(flight, 5) : path_of(flight, 5), 6);
    out << "set label \"Δ{/:Italic t} = " << program::readable(dt) << "\" at 4.9, " << label_height
        << " right tc rgb " << pen << "\n";
    label_height -= 2.2;
    plot += std::string(plot.size() > 5 ? ", " : "") + "$" + name + " with " +
            (dt > 0.01 ? "linespoints pt 7 ps 0.55" : "lines") + " lc rgb " + pen + " lw 2";
  }
  out << plot << "\n";
  figure.draw();
}

// Energy over a minute, in units of what it was.
void draw_energy(const Program& program) {
  const double g = 9.81;
  Figure figure(program.studio(), "energy", {720, 440});
  const auto add = [&](const char* name, Stepper stepper) {
    Table rows;
    double last = -1;
    for (const Stepped& state : stepped_bounce(stepper, 1, g, 1, 1.0 / 60, 3600)) {
      const double energy = state.energy(g) / g;
      if (std::abs(energy - last) > 0.004 || state.time >= 60)
        rows.push_back({state.time, last < 0 ? energy : last});
      if (std::abs(energy - last) > 0.004) rows.push_back({state.time, last = energy});
    }
    figure.data(name, rows, 5);
  };
  add("explicit", Stepper::explicit_euler);
  add("parabola", Stepper::parabola);
  add("semi", Stepper::semi_implicit_euler);
  std::ostream& out = figure.script();
  write_axes(out, program, {"energy, of what it was", "能量（與初值之比）"}, {"time (s)", "時間（秒）"});
  out << "set xrange [0:60]\nset yrange [0:10]\nset ytics 2\n"
      << "set label 1 \"" << program.say({"explicit Euler", "顯式歐拉法"})
      << "\" at 39, 7.6 right tc rgb RED\n"
      << "set label 2 \"" << program.say({"exact parabolas", "精確拋物線"})
      << "\" at 59, 2.3 right tc rgb PINK\n"
      << "set label 3 \"" << program.say({"semi-implicit Euler", "半隱式歐拉法"})
      << "\" at 59, 0.42 right tc rgb BLUE\n"
      << "set label 4 \"" << program.say({"solved at impacts", "於碰撞時求解"})
      << "\" at 59, 1.42 right tc rgb GREEN\n"
      << "plot $explicit with lines lc rgb RED lw 2, $parabola with lines lc rgb PINK lw 2, "
      << "$semi with lines lc rgb BLUE lw 1.6, 1 with lines lc rgb GREEN lw 2.2\n";
  figure.draw();
}

}  // namespace

void draw_bounces(const Program& program, const Flight& printed, const Flight& physical) {
  draw_printed_and_physical(program, printed, physical);
  draw_steps(program);
  draw_energy(program);
}

}  // namespace tween_bounce
