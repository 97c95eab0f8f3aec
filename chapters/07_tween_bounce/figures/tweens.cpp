#include <algorithm>
#include <cmath>

#include "figures.hpp"
#include "first_contact/figure/animation.hpp"
#include "first_contact/motion/arc_length.hpp"
#include "first_contact/motion/easing.hpp"

using namespace first_contact;
using namespace first_contact::figure;
using program::Program;
using program::Text;

namespace tween_bounce {

namespace {

Table curve_rows(const Curve& curve, int steps) {
  Table rows;
  for (int i = 0; i <= steps; ++i) {
    const Point p = at(curve, static_cast<double>(i) / steps);
    rows.push_back({p.x(), p.y()});
  }
  return rows;
}

Table point_rows(const std::vector<Point>& points) {
  Table rows;
  for (const Point& p : points) rows.push_back({p.x(), p.y()});
  return rows;
}

// A graph to within a hair's breadth: steep and sharp parts keep their points.
Table easing_rows(Easing easing) {
  std::vector<Moment> graph;
  for (int i = 0; i <= 2000; ++i) graph.push_back({i / 2000.0, {i / 2000.0, easing(i / 2000.0)}});
  Table rows;
  for (const Moment& moment : sparse(graph, 0.003)) rows.push_back({moment.at.x(), moment.at.y()});
  return rows;
}

// Ten families of easings, each in, out and in-out.
void draw_easings(const Program& program) {
  static const Text families[]{{"quadratic", "二次"}, {"cubic", "三次"}, {"quartic", "四次"},
                               {"quintic", "五次"},   {"sine", "正弦"},  {"exponential", "指數"},
                               {"circular", "圓"},    {"back", "回拉"},  {"elastic", "彈簧"},
                               {"bounce", "彈跳"}};
  Figure figure(program.studio(), "easings", {720, 400});
  const auto all = ease::all();
  for (std::size_t k = 1; k < all.size(); ++k)
    figure.data("easing" + std::to_string(k), easing_rows(all[k].easing), 4);
  std::ostream& out = figure.script();
  out << "unset key\nunset xlabel\nunset tics\nset border 3 lc rgb GREY\nset xrange [-0.03:1.03]\nset yrange "
         "[-0.42:1.42]\n"
      << "set multiplot\n"
      << "set label 11 \"" << program.say({"in", "緩入"}) << "\" at screen 0.30, 0.035 center tc rgb RED\n"
      << "set label 12 \"" << program.say({"out", "緩出"}) << "\" at screen 0.50, 0.035 center tc rgb BLUE\n"
      << "set label 13 \"" << program.say({"in-out", "緩入緩出"})
      << "\" at screen 0.70, 0.035 center tc rgb GREEN\n";
  for (std::size_t k = 0; k < 10; ++k) {
    const double left = 0.025 + 0.195 * static_cast<double>(k % 5), bottom = k < 5 ? 0.56 : 0.105;
    out << "set lmargin at screen " << left << "\nset rmargin at screen " << left + 0.17
        << "\nset bmargin at screen " << bottom << "\nset tmargin at screen " << bottom + 0.355
        << "\nset label 1 \"" << program.say(families[k])
        << "\" at graph 0.5, 1.06 center font \",14\" tc rgb INK\n"
        << "plot 1 with lines lc rgb PALE lw 1, 0 with lines lc rgb PALE lw 1, $easing" << 1 + 3 * k
        << " with lines lc rgb RED lw 1.8, $easing" << 2 + 3 * k << " with lines lc rgb BLUE lw 1.8, $easing"
        << 3 + 3 * k << " with lines lc rgb GREEN lw 1.8\nunset label 11\nunset label 12\nunset label 13\n";
  }
  out << "unset multiplot\n";
  figure.draw();
}

// The same control points for a Bezier curve, a clamped B-spline, and one that is not clamped.
void draw_curves(const Program& program) {
  const std::vector<Point> control{{0, 0.4, 0},   {0.6, 3.2, 0}, {2.6, 3.4, 0}, {3.6, 0.2, 0},
                                   {5.4, 0.1, 0}, {6.2, 2.9, 0}, {8, 3.1, 0}};
  const BSpline loose(control, 3, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
  Figure figure(program.studio(), "curves", {720, 380});
  figure.data("control", point_rows(control));
  figure.data("bezier", curve_rows(Bezier(control), 120), 5);
  figure.data("spline", curve_rows(BSpline(control, 3), 120), 5);
  figure.data("loose", curve_rows(loose, 80), 5);
  std::ostream& out = figure.script();
  out << "unset border\nunset tics\nunset key\nset lmargin at screen 0.04\nset rmargin at screen 0.96\n"
      << "set bmargin at screen 0.05\nset tmargin at screen 0.95\nset xrange [-0.35:8.55]\nset yrange "
         "[-0.45:3.9]\n";
  for (std::size_t i = 0; i < control.size(); ++i) {
    const bool above = control[i].y() > 1;
    out << "set label " << i + 1 << " \"{/:Italic P}_" << i << "\" at " << control[i].x() << ","
        << control[i].y() + (above ? 0.27 : -0.3) << " center tc rgb INK\n";
  }
  out << "set label 11 \"Bezier\" at 4.62, 1.98 center tc rgb RED\n"
      << "set label 12 \"" << program.say({"B-spline, clamped", "B-spline（端點固定）"})
      << "\" at 1.85, 0.95 center tc rgb BLUE\n"
      << "set label 13 \"" << program.say({"not clamped:\\nmisses its ends", "端點未固定：\\n不達兩端"})
      << "\" at 6.15, 1.15 left tc rgb GREY\n"
      << "plot $control with lines lc rgb PALE lw 1.4, $loose with lines lc rgb GREY lw 2 dt (6,5), "
      << "$bezier with lines lc rgb RED lw 2.4, $spline with lines lc rgb BLUE lw 2.4, "
      << "$control with points pt 7 ps 0.7 lc rgb INK\n";
  figure.draw();
}

// Equal steps of the parameter, and equal steps of the length.
void draw_spacing(const Program& program) {
  const ArcLength length(arch());
  const int steps = 24;
  Table by_parameter, by_length;
  for (int i = 0; i <= steps; ++i) {
    const double part = static_cast<double>(i) / steps;
    const Point p = at(length.curve(), part), q = length.at(part);
    by_parameter.push_back({p.x(), p.y()});
    by_length.push_back({q.x(), q.y()});
  }
  Figure figure(program.studio(), "spacing", {720, 220});
  figure.data("arch", curve_rows(length.curve(), 100), 5);
  figure.data("parameter", by_parameter, 5);
  figure.data("length", by_length, 5);
  std::ostream& out = figure.script();
  out << "unset border\nunset tics\nunset key\nset xrange [-0.4:8.4]\nset yrange [-0.35:3.35]\nset "
         "multiplot\n"
      << "set bmargin at screen 0.27\nset tmargin at screen 0.9027\n";
  const auto panel = [&](double left, const char* data, const char* ink, const Text& words) {
    out << "set lmargin at screen " << left << "\nset rmargin at screen " << left + 0.46 << "\nset label 1 \""
        << program.say(words) << "\" at graph 0.5, -0.2 center tc rgb " << ink << "\n"
        << "plot $arch with lines lc rgb PALE lw 2, " << data << " with points pt 7 ps 0.75 lc rgb " << ink
        << "\n";
  };
  panel(0.02, "$parameter", "PINK", {"equal steps of the parameter", "參數等距"});
  panel(0.52, "$length", "GREEN", {"equal steps of the arc length", "弧長等距"});
  out << "unset multiplot\n";
  figure.draw();
}

}  // namespace

void draw_tweens(const Program& program) {
  draw_easings(program);
  draw_curves(program);
  draw_spacing(program);
}

}  // namespace tween_bounce
