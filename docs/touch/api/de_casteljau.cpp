// Chapter 7: a Bezier curve of four control points: what is cut off, and where it is by its length.
#include "07_tween_bounce/bent.hpp"
#include "first_contact/motion/arc_length.hpp"
#include "page.hpp"

using namespace first_contact;
using touch::tell;

namespace {

void append(std::vector<double>& numbers, const Point& p) { numbers.insert(numbers.end(), {p.x(), p.y()}); }

void tell_drawing(const Bezier& curve, double parameter, bool even) {
  constexpr int pieces = 96, steps = 24;
  std::vector<double> line, dots, levels;
  for (int i = 0; i <= pieces; ++i) append(line, curve.at(double(i) / pieces));
  const ArcLength length(curve);
  for (int i = 0; i <= steps; ++i) {
    const double part = double(i) / steps;
    append(dots, even ? length.at(part) : curve.at(part));
  }
  for (const auto& level : tween_bounce::cut_corners(curve, parameter))
    for (const Point& point : level) append(levels, point);
  tell("drawn/line", line);
  tell("drawn/dots", dots);
  tell("drawn/levels", levels);
}

}  // namespace

FOR_THE_PAGE(de_casteljau)
(double ax, double ay, double bx, double by, double cx, double cy, double dx, double dy, double part,
 double even) {
  const Bezier curve({{ax, ay, 0}, {bx, by, 0}, {cx, cy, 0}, {dx, dy, 0}});
  const tween_bounce::Bent bent = tween_bounce::bent(curve, part);
  tell("curve/length", bent.length);
  tell("curve/speed", bent.speed);
  tell("curve/point", bent.point);
  tell("curve/even_parameter", bent.even_parameter);
  tell("curve/even_point", bent.even_point);
  tell_drawing(curve, even != 0 ? bent.even_parameter : part, even != 0);
}
