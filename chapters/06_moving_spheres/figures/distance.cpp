#include <algorithm>
#include <cmath>

#include "figures.hpp"
#include "first_contact/figure/figure.hpp"
#include "first_contact/sweep/sphere_sphere.hpp"

using namespace first_contact;
using namespace first_contact::figure;

namespace {

constexpr const char* distance_script = R"(unset key
set border 3
set xtics 0, 1 font ",15"
set ytics 0, 2 font ",15"
set lmargin at screen 0.07
set rmargin at screen 0.965
set tmargin at screen 0.9
set bmargin at screen 0.15
set label 1 name at screen 0.02, 0.955 left tc rgb INK
set label 2 "{/:Italic t}" at screen 0.5175, 0.05 center tc rgb INK
set label 3 "{/:Italic d}" at latest, reach offset 0, 0.7 right tc rgb BLUE
set label 4 "{/:Italic t}_1" at t1, 0 offset 0, 0.8 center tc rgb GREEN front
set label 5 "{/:Italic t}_2" at t2, 0 offset 0, 0.8 center tc rgb GREEN front
set label 6 miss at 0.5 * (t1 + t2), 2.35 * reach center tc rgb GREY
set label 7 approach at graph 0.03, first 1.6 * reach left tc rgb INK
set label 8 leave at graph 0.97, first 1.6 * reach right tc rgb INK
set arrow 1 from t1, reach to t1, 0.42 * reach nohead lc rgb GREEN lw 1.4 dt (5,4)
set arrow 2 from t2, reach to t2, 0.42 * reach nohead lc rgb GREEN lw 1.4 dt (5,4)
set arrow 3 from earliest, reach to latest, reach nohead lc rgb BLUE lw 1.6
plot $inside using 1:2:(reach) with filledcurves fc rgb FLOOR notitle, \
 $beside using 1:2 with lines lc rgb GREY lw 1.6 dt (7,5), \
 $distance using 1:2 with lines lc rgb RED lw 2.4, $contacts using 1:2 with points pt 7 ps 0.9 lc rgb INK
)";

}  // namespace

void draw_distance(const program::Program& program, const Moving<Sphere>& p, const Moving<Sphere>& q) {
  const auto times = contact_interval(p, q);
  if (!times || !(times->begin < times->end)) return;
  const Vector w = p.shape.center - q.shape.center, u = p.displacement - q.displacement;
  const double reach = p.shape.radius + q.shape.radius, speed = u.norm();
  const double middle = 0.5 * (times->begin + times->end), half = 5 * reach / speed;
  const auto rows = [](double from, double to, const auto& height) {
    Table table;
    for (int i = 0; i <= 120; ++i) {
      const double t = std::lerp(from, to, i / 120.0);
      table.push_back({t, height(t)});
    }
    return table;
  };
  const auto distance = [&](double t) { return (w + t * u).norm(); };
  const auto beside = [&](double t) { return std::hypot(1.5 * reach, speed * (t - middle)); };
  Figure figure(program.studio(), "distance", {720, 400});
  figure.data("distance", rows(middle - half, middle + half, distance), 5);
  figure.data("beside", rows(middle - half, middle + half, beside), 5);
  figure.data("inside", rows(times->begin, times->end, distance), 5);
  figure.data("contacts", {{times->begin, reach}, {times->end, reach}}, 6);
  std::ostream& out = figure.script();
  out << "reach = " << reach << "\nt1 = " << times->begin << "\nt2 = " << times->end
      << "\nearliest = " << middle - half << "\nlatest = " << middle + half
      << "\nset xrange [earliest:latest]\nset yrange [0:" << 5 * reach << "]\n";
  program.label(figure, "name", {"distance of the centres", "球心距離"});
  program.label(figure, "miss", {"passing by: no root", "錯身而過：無實根"});
  program.label(figure, "approach", {"nearer and nearer", "愈靠愈近"});
  program.label(figure, "leave", {"apart again", "愈離愈遠"});
  out << distance_script;
  figure.draw();
}
