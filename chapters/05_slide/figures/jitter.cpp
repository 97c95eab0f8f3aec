#include "jitter.hpp"

#include "figures.hpp"
#include "first_contact/figure/figure.hpp"

using namespace first_contact;
using namespace first_contact::figure;

void draw_jitter(const program::Program& program) {
  const int frames = 40;
  const Environment bend(wide_corner);
  const Frames naive = wall_after_wall_frames(into_wide_corner, bend, frames);
  const Frames both = slide_frames(into_wide_corner, bend, frames);
  const auto rows = [](const Frames& run) {
    Table table;
    for (std::size_t i = 0; i < run.positions.size(); ++i)
      table.push_back({static_cast<double>(i), run.positions[i].y()});
    return table;
  };
  Figure figure(program.studio(), "jitter", {720, 300});
  figure.data("naive", rows(naive), 5);
  figure.data("both", rows(both), 5);
  figure.script()
      << "set lmargin at screen 0.095\nset rmargin at screen 0.975\nset bmargin at screen 0.25\n"
      << "set tmargin at screen 0.86\nset grid\nunset key\nset xrange [0:" << frames
      << "]\nset yrange [-0.15:0.3]\nset ytics 0.1\nset xtics font \",15\"\nset ytics font \",15\"\n"
      << "set label 1 \"" << program.say({"beside the corner", "偏離角落的距離"})
      << "\" at screen 0.02, 0.93 left tc rgb INK\nset label 2 \"" << program.say({"frame", "影格"})
      << "\" at screen 0.535, 0.05 center tc rgb INK\nset label 3 \""
      << program.say({"one wall after the other", "逐牆投影"})
      << "\" at 24, 0.14 center tc rgb PINK\nset label 4 \""
      << program.say({"both walls at once", "兼顧兩牆"}) << "\" at 24, -0.105 center tc rgb GREEN\n"
      << "plot $naive with linespoints pt 7 ps 0.45 lc rgb PINK lw 1.6, $both with linespoints pt 7 ps "
         "0.45 lc rgb GREEN lw 2.2\n";
  figure.draw();
}
