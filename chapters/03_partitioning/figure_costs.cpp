#include <cmath>

#include "figures.hpp"
#include "first_contact/partition/brute_force.hpp"
#include "first_contact/partition/bsp_tree.hpp"
#include "measure.hpp"
#include "room.hpp"

using namespace first_contact;
using namespace first_contact::figure;

namespace {

constexpr std::size_t largest = 16384;

// Rows of log_2 k and what was measured: depths of points, mean and deepest, then tests in octree and BSP
// tree.
Table rows(Spread spread, std::uint64_t seed) {
  Table table;
  for (std::size_t k = 8; k <= largest; k *= 2) {
    const Depth depth = depth_of_objects(Octree(points(k, spread, seed), OctreeLimits{1, 20}));
    const auto triangles = shards(k, spread, seed);
    const Soup<Octree> octree(triangles);
    const auto balls = flights_at(triangles, 200, octree.bounds(), seed + 1);
    const Cost in_octree = measure(octree, balls), in_bsp = measure(Soup<BspTree>(triangles), balls);
    table.push_back({std::log2(static_cast<double>(k)), depth.mean, static_cast<double>(depth.deepest),
                     in_octree.per_flight(in_octree.tests), in_bsp.per_flight(in_bsp.tests)});
  }
  return table;
}

// Two charts, one above the other: depths, and tests done.
constexpr const char* costs_script = R"(unset key
set grid
set xrange [3:14]
set xtics ("8" 3, "64" 6, "512" 9, "4096" 12) font ",14"
set lmargin at screen 0.115
set rmargin at screen 0.775
set multiplot
set tmargin at screen 0.935
set bmargin at screen 0.56
set yrange [0:12]
set ytics 0, 2 font ",14"
set xtics ("" 3, "" 6, "" 9, "" 12)
set label 1 steps at graph -0.09, 1.07 left font ",16" tc rgb INK
set label 2 "log_8 {/:Italic k}" at 14.15, 4.67 left font ",15" tc rgb GREY
set label 3 evenly at 14.15, 5.6 left font ",15" tc rgb BLUE
set label 4 crowded at 14.15, 10 left font ",15" tc rgb RED
plot [3:14] x / 3 with lines lc rgb GREY lw 1.6 dt (6,5), \
 $even using 1:2 with linespoints lc rgb BLUE lw 2.2 pt 7 ps 0.5, \
 $clustered using 1:2 with linespoints lc rgb RED lw 2.2 pt 7 ps 0.5
unset label
set xtics ("8" 3, "64" 6, "512" 9, "4096" 12) font ",14"
set tmargin at screen 0.46
set bmargin at screen 0.13
set yrange [0:14]
set ytics ("1" 0, "8" 3, "64" 6, "512" 9, "4096" 12) font ",14"
set label 1 tests at graph -0.09, 1.07 left font ",16" tc rgb INK
set label 2 none at 12.0, 12.6 right font ",15" tc rgb GREY
set label 3 in_bsp at 14.15, 6.9 left font ",15" tc rgb RED
set label 4 in_octree at 14.15, 5.9 left font ",15" tc rgb RED
set label 5 in_bsp at 14.15, 4.85 left font ",15" tc rgb BLUE
set label 6 in_octree at 14.15, 3.8 left font ",15" tc rgb BLUE
set xlabel objects font ",16" offset 0, 0.3
log2(x) = log(x) / log(2)
plot [3:14] x with lines lc rgb GREY lw 1.6 dt (6,5), \
 $even using 1:(log2($4)) with linespoints lc rgb BLUE lw 2.2 pt 7 ps 0.5, \
 $even using 1:(log2($5)) with linespoints lc rgb BLUE lw 2.2 dt (8,4) pt 5 ps 0.5, \
 $clustered using 1:(log2($4)) with linespoints lc rgb RED lw 2.2 pt 7 ps 0.5, \
 $clustered using 1:(log2($5)) with linespoints lc rgb RED lw 2.2 dt (8,4) pt 5 ps 0.5
unset multiplot
)";

}  // namespace

void draw_costs(const program::Program& program, std::uint64_t seed) {
  Figure figure(program.studio(), "costs", {760, 760});
  figure.data("even", rows(Spread::even, seed), 5);
  figure.data("clustered", rows(Spread::clustered, seed), 5);
  const auto& say = [&](const char* english, const char* chinese) { return program.say({english, chinese}); };
  figure.script() << "steps = \"" << say("depth of an object, octree", "物品的深度（八元樹）") << "\"\n"
                  << "tests = \"" << say("tests on a flight", "每次飛行的測試數") << "\"\n"
                  << "objects = \"" << say("objects {/:Italic k}", "物品數 {/:Italic k}") << "\"\n"
                  << "evenly = \"" << say("evenly spread", "均勻分布") << "\"\n"
                  << "crowded = \"" << say("clustered", "聚集") << "\"\n"
                  << "none = \"" << say("no structure: {/:Italic k}", "不分割：{/:Italic k}") << "\"\n"
                  << "in_bsp = \"BSP tree\"\n"
                  << "in_octree = \"" << say("octree", "八元樹") << "\"\n"
                  << costs_script;
  figure.draw();
}
