#include <cmath>

#include "figures.hpp"
#include "first_contact/trees/box_tree.hpp"
#include "first_contact/trees/bsp_tree.hpp"
#include "measure.hpp"
#include "room.hpp"

using namespace first_contact;
using namespace first_contact::figure;

namespace {

constexpr std::size_t largest = 16384;

// Rows of log_2 k and, for octree, BSP tree and BVH in turn: how deep a splinter lies if each has a leaf to
// itself; how often it was looked at to build the tree; tests on a flight.
Table rows(Spread spread, std::uint64_t seed) {
  Table table;
  for (std::size_t k = 8; k <= largest; k *= 2) {
    const auto triangles = shards(k, spread, seed);
    const Soup<Octree> octree(triangles);
    const Soup<BspTree> bsp(triangles);
    const Soup<BoxTree> bvh(triangles);
    const auto balls = flights_at(triangles, 200, octree.bounds(), seed + 1);
    const std::vector<Cost> costs{measure(octree, balls), measure(bsp, balls), measure(bvh, balls)};
    std::vector<double> row{std::log2(static_cast<double>(k))};
    row.push_back(depth_of_objects(Octree(triangles, OctreeLimits{1, 20})).mean);
    row.push_back(depth_of_objects(BspTree(triangles, BspLimits{1, 64, 16, 8})).mean);
    row.push_back(depth_of_objects(BoxTree(triangles, BoxTreeLimits{1})).mean);
    for (const Cost& cost : costs) row.push_back(static_cast<double>(cost.work) / static_cast<double>(k));
    for (const Cost& cost : costs) row.push_back(cost.per_flight(cost.tests));
    table.push_back(row);
  }
  return table;
}

// Three rows of charts, depth, building, tests; on the left objects that lie evenly, on the right clustered
// ones.
constexpr const char* costs_script = R"(unset key
set grid
set xrange [3:14]
log2(x) = log(x) / log(2)
left(c) = c == 0 ? 0.1 : 0.505
right(c) = c == 0 ? 0.47 : 0.875
shade(t) = t == 0 ? BLUE : t == 1 ? RED : GREEN
set multiplot
do for [c = 0:1] {
  set lmargin at screen left(c)
  set rmargin at screen right(c)
  set xtics ("" 3, "" 6, "" 9, "" 12)
  unset xlabel

  set tmargin at screen 0.895
  set bmargin at screen 0.665
  set yrange [0:20]
  set ytics 0, 5 font ",14"
  if (c == 1) { set format y "" }
  set label 1 (c == 0 ? steps : "") at graph -0.13, 1.1 left font ",16" tc rgb INK
  set label 2 (c == 0 ? evenly : crowded) at screen 0.5 * (left(c) + right(c)), screen 0.975 center font ",17" tc rgb GREY
  if (c == 1) {
    set label 3 "log_2 {/:Italic k}" at 14.2, 14.2 left font ",14" tc rgb GREY
    set label 4 "log_8 {/:Italic k}" at 14.2, 4.667 left font ",14" tc rgb GREY
  }
  plot [3:14] x / 3 with lines lc rgb GREY lw 1.6 dt (6,5), x with lines lc rgb GREY lw 1.2 dt (2,4), \
   for [t = 0:2] $both index c using 1:(column(2 + t)) with linespoints lc rgb shade(t) lw 2.2 pt 7 ps 0.45
  unset label

  set tmargin at screen 0.605
  set bmargin at screen 0.375
  set yrange [0:9]
  set ytics ("1" 0, "4" 2, "16" 4, "64" 6, "256" 8) font ",14"
  if (c == 1) {
    set ytics ("" 0, "" 2, "" 4, "" 6, "" 8)
    set label 3 "BSP tree" at 14.2, 7.9 left font ",14" tc rgb RED
    set label 4 "BVH" at 14.2, 6.05 left font ",14" tc rgb GREEN
    set label 5 in_octree at 14.2, 3.1 left font ",14" tc rgb BLUE
  }
  set label 1 (c == 0 ? building : "") at graph -0.13, 1.1 left font ",16" tc rgb INK
  plot for [t = 0:2] $both index c using 1:(log2(column(5 + t))) with linespoints lc rgb shade(t) lw 2.2 pt 7 ps 0.45
  unset label

  set tmargin at screen 0.315
  set bmargin at screen 0.105
  set xtics ("8" 3, "64" 6, "512" 9, "4096" 12) font ",14"
  set xlabel (c == 0 ? objects : "") font ",16" offset 0, 0.6 textcolor rgb INK
  set yrange [0:14]
  set ytics ("1" 0, "8" 3, "64" 6, "512" 9, "4096" 12) font ",14"
  if (c == 1) { set ytics ("" 0, "" 3, "" 6, "" 9, "" 12) }
  set label 1 (c == 0 ? tests : "") at graph -0.13, 1.1 left font ",16" tc rgb INK
  set label 2 (c == 0 ? none : "") at 10.6, 12.2 right font ",14" tc rgb GREY
  plot [3:14] x with lines lc rgb GREY lw 1.6 dt (6,5), \
   for [t = 0:2] $both index c using 1:(log2(column(8 + t))) with linespoints lc rgb shade(t) lw 2.2 pt 7 ps 0.45
  unset label
  set format y
}
unset multiplot
)";

}  // namespace

void draw_costs(const program::Program& program, std::uint64_t seed) {
  Figure figure(program.studio(), "costs", {760, 900});
  Table both = rows(Spread::even, seed);
  both.resize(both.size() + 2);  // two blank lines
  for (const auto& row : rows(Spread::clustered, seed)) both.push_back(row);
  figure.data("both", both, 5);
  program.label(figure, "steps", {"depth of an object", "物品的深度"});
  program.label(figure, "building", {"building: looks at an object", "建樹：每個物品被檢視的次數"});
  program.label(figure, "tests", {"tests on a flight", "每次飛行的測試數"});
  program.label(figure, "objects", {"objects {/:Italic k}", "物品數 {/:Italic k}"});
  program.label(figure, "evenly", {"evenly spread", "均勻分布"});
  program.label(figure, "crowded", {"clustered", "聚集"});
  program.label(figure, "none", {"no structure", "不分割"});
  program.label(figure, "in_octree", {"octree", "八元樹"});
  figure.script() << costs_script;
  figure.draw();
}
