#include "growth.hpp"

#include <cmath>

#include "figures.hpp"

using namespace first_contact;
using namespace first_contact::figure;

namespace {

// Rows of n and, all as powers of ten: one axis, boxes tested, pairs swept.
Table rows(Crowd kind) {
  const auto power = [](std::size_t count) { return std::log10(static_cast<double>(count)); };
  Table table;
  for (const std::size_t n : {100U, 316U, 1000U, 3162U, 10000U, 31623U, 100000U}) {
    const Work done = work(n, kind);
    table.push_back({power(n), power(done.one_axis), power(done.boxes), power(done.sweeps)});
  }
  return table;
}

constexpr const char* growth_script = R"(unset key
set grid
set lmargin at screen 0.095
set rmargin at screen 0.74
set tmargin at screen 0.925
set bmargin at screen 0.165
set xrange [2:5]
set xtics 2, 1 font ",14"
set format x "10^{%.0f}"
set yrange [2:10]
set ytics 2, 2 font ",14"
set format y "10^{%.0f}"
set xlabel spheres font ",16" offset 0, 0.3
log2(x) = log(x) / log(2)
set label 1 tests at graph -0.07, 1.055 left font ",16" tc rgb INK
set label 2 every_pair at 5.05, 9.7 left font ",15" tc rgb GREY
set label 3 one_axis at 5.05, 8.28 left font ",15" tc rgb ORANGE
set label 4 uneven at 5.05, 7.02 left font ",15" tc rgb RED
set label 5 alike at 5.05, 6.62 left font ",15" tc rgb BLUE
set label 6 "{/:Italic n} log_2 {/:Italic n}" at 5.05, 6.18 left font ",15" tc rgb GREY
set label 7 swept at 5.05, 5.44 left font ",15" tc rgb GREEN
plot [2:5] log10(10**x * (10**x - 1) / 2) with lines lc rgb GREY lw 1.6 dt (6,5), \
 log10(10**x * log2(10**x)) with lines lc rgb GREY lw 1.6 dt (6,5), \
 $alike using 1:2 with linespoints lc rgb ORANGE lw 2.2 pt 7 ps 0.5, \
 $uneven using 1:3 with linespoints lc rgb RED lw 2.2 pt 7 ps 0.5, \
 $alike using 1:3 with linespoints lc rgb BLUE lw 2.2 pt 7 ps 0.5, \
 $alike using 1:4 with linespoints lc rgb GREEN lw 2.2 pt 7 ps 0.5
)";

}  // namespace

void draw_growth(const program::Program& program) {
  Figure figure(program.studio(), "growth", {760, 560});
  figure.data("alike", rows(Crowd::alike), 5);
  figure.data("uneven", rows(Crowd::uneven), 5);
  program.label(figure, "tests", {"tests", "測試數"});
  program.label(figure, "spheres", {"spheres {/:Italic n}", "球數 {/:Italic n}"});
  program.label(figure, "every_pair", {"every pair", "每一對"});
  program.label(figure, "one_axis", {"sorted along {/:Italic x}", "沿 {/:Italic x} 排序"});
  program.label(figure, "uneven", {"boxes, if uneven", "匣面（大小快慢不一）"});
  program.label(figure, "alike", {"boxes, if alike", "匣面（大小快慢相近）"});
  program.label(figure, "swept", {"pairs swept", "精確計算的成對的球"});
  figure.script() << growth_script;
  figure.draw();
}
