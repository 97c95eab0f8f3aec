#include "far_away.hpp"

#include <cmath>

#include "figures.hpp"
#include "first_contact/figure/figure.hpp"

using namespace first_contact;
using namespace first_contact::figure;

namespace {

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

}  // namespace

void draw_far_away(const program::Program& program) {
  Figure figure(program.studio(), "far-away", {720, 700});
  add_curve(figure, "printed_single", measure<float>(Formula::textbook));
  add_curve(figure, "printed_double", measure<double>(Formula::textbook));
  add_curve(figure, "stable_single", measure<float>(Formula::closest_approach));
  add_curve(figure, "stable_double", measure<double>(Formula::closest_approach));
  program.label(figure, "printed_s", {"printed, single", "論文原式，單精度"});
  program.label(figure, "printed_d", {"printed, double", "論文原式，雙精度"});
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
