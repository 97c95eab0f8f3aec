#include "accuracy.hpp"

#include <algorithm>
#include <cmath>

#include "figures.hpp"
#include "first_contact/figure/figure.hpp"

using namespace first_contact;
using namespace first_contact::figure;
using namespace general_sphere_chapter;

namespace {

// Decades of distance and of error; an error of 0 would have no logarithm.
Table rows(const std::vector<program::Accuracy>& measured) {
  Table table;
  for (const program::Accuracy& each : measured)
    if (std::isfinite(each.error))
      table.push_back({std::log10(each.distance), std::log10(std::max(each.error, 1e-17))});
  return table;
}

Table rows(const std::vector<Wrong>& measured) {
  Table table;
  for (const Wrong& each : measured) table.push_back({std::log10(each.size), 100 * each.share});
  return table;
}

constexpr const char* accuracy_script = R"(unset key
set grid
set lmargin at screen 0.115
set rmargin at screen 0.96
set format x "10^{%.0f}"
set multiplot
set tmargin at screen 0.935
set bmargin at screen 0.58
set xrange [0:10]
set xtics 0, 2 font ",14"
set yrange [-17:0]
set ytics -16, 4 font ",14"
set format y "10^{%.0f}"
set label 1 error at graph -0.08, 1.08 left font ",16" tc rgb INK
set label 2 book_s at 3.2, -2.2 right font ",15" tc rgb PINK
set label 3 stable_s at 6.3, -6.2 right font ",15" tc rgb GREEN
set label 4 book_d at 5.2, -9.5 right font ",15" tc rgb PINK
set label 5 stable_d at 6.3, -14.4 left font ",15" tc rgb GREEN
set xlabel distance font ",16" offset 0, 0.6
plot $book_single using 1:2 with lines lc rgb PINK lw 2.2 dt (8,5), \
 $stable_single using 1:2 with lines lc rgb GREEN lw 2.2 dt (8,5), \
 $book_double using 1:2 with lines lc rgb PINK lw 2.2, \
 $stable_double using 1:2 with lines lc rgb GREEN lw 2.2
unset label
set tmargin at screen 0.405
set bmargin at screen 0.125
set xrange [-6:6]
set xtics -6, 2 font ",14"
set yrange [-2:60]
set ytics 0, 25 font ",14"
set format y "%g"
set label 1 wrong at graph -0.08, 1.1 left font ",16" tc rgb INK
set label 2 determinant at -5.8, 55 left font ",15" tc rgb ORANGE
set label 3 areas_s at 1.6, 36 left font ",15" tc rgb PINK
set label 4 areas_d at 5.05, 14 right font ",15" tc rgb PINK
set label 5 none at -0.45, 5 center font ",15" tc rgb GREEN
set xlabel size font ",16" offset 0, 0.6
plot $determinant using 1:2 with lines lc rgb ORANGE lw 2.2, \
 $areas_single using 1:2 with lines lc rgb PINK lw 2.2 dt (8,5), \
 $areas_double using 1:2 with lines lc rgb PINK lw 2.2, \
 $weights using 1:2 with lines lc rgb GREEN lw 2.2
unset multiplot
)";

}  // namespace

void draw_accuracy(const program::Program& program) {
  Figure figure(program.studio(), "accuracy", {720, 780});
  figure.data("book_single", rows(accuracy_at_an_edge<float>(EdgeFormula::textbook)), 4);
  figure.data("stable_single", rows(accuracy_at_an_edge<float>(EdgeFormula::stable)), 4);
  figure.data("book_double", rows(accuracy_at_an_edge<double>(EdgeFormula::textbook)), 4);
  figure.data("stable_double", rows(accuracy_at_an_edge<double>(EdgeFormula::stable)), 4);
  figure.data("determinant", rows(wrong_answers<double>(RayTest::determinant)), 4);
  figure.data("areas_single", rows(wrong_answers<float>(RayTest::areas)), 4);
  figure.data("areas_double", rows(wrong_answers<double>(RayTest::areas)), 4);
  figure.data("weights", rows(wrong_answers<double>(RayTest::weights)), 4);
  program.label(figure, "error",
                {"relative error of {/:Italic t}, at an edge", "{/:Italic t} 的相對誤差（稜）"});
  program.label(figure, "distance",
                {"distance at the start, in {/:Italic r}", "出發時的距離（以 {/:Italic r} 計）"});
  program.label(figure, "book_s", {"textbook, single", "教科書公式，單精度"});
  program.label(figure, "book_d", {"textbook, double", "教科書公式，雙精度"});
  program.label(figure, "stable_s", {"stable, single", "穩定形式，單精度"});
  program.label(figure, "stable_d", {"stable, double", "穩定形式，雙精度"});
  program.label(figure, "wrong", {"wrong answers, %", "錯誤的答案（%）"});
  program.label(figure, "size", {"size of the scene", "場景的大小"});
  program.label(figure, "determinant", {"determinant, 10^{−5}", "行列式，10^{−5}"});
  program.label(figure, "areas_s", {"areas, 10^{−5}, single", "面積，10^{−5}，單精度"});
  program.label(figure, "areas_d", {"areas, double", "面積，雙精度"});
  program.label(figure, "none", {"no tolerance", "無容許值"});
  figure.script() << accuracy_script;
  figure.draw();
}
