#include "first_contact/motion/css_easing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "first_contact/geometry/refuse.hpp"
#include "first_contact/geometry/space.hpp"

namespace first_contact::ease {

namespace {

// One coordinate of the curve: 0, a, b, 1.
double cubic(double a, double b, double u) {
  const double v = 1 - u;
  return u * (3 * v * (v * a + u * b) + u * u);
}

double parameter_of(double x1, double x2, double x) {
  double low = 0, high = 1;
  for (;;) {
    const double middle = (low + high) / 2;
    if (!(middle > low && middle < high)) return high;
    (cubic(x1, x2, middle) < x ? low : high) = middle;
  }
}

void require_in(double low, double high, const char* what, double value, const char* rule) {
  if (!(value >= low && value <= high)) refuse(what, value, rule);
}

// Which part of the way from the one to the other: two that are so far apart that their difference overflows are halved
// first.
double part_between(double from, double to, double t) {
  if (std::isfinite(to - from)) return (t - from) / (to - from);
  return (t / 2 - from / 2) / (to / 2 - from / 2);
}

void fill_inputs(std::vector<Stop>& stops) {
  if (!stops.front().input) stops.front().input = 0;
  if (!stops.back().input) stops.back().input = 1;
  double largest = *stops.front().input;
  for (Stop& stop : stops)
    if (stop.input) largest = *(stop.input = std::max(*stop.input, largest));
  for (std::size_t i = 1; i < stops.size(); ++i) {
    if (stops[i].input) continue;
    std::size_t next = i;
    while (!stops[next].input) ++next;
    const double from = *stops[i - 1].input, to = *stops[next].input,
                 pieces = static_cast<double>(next - i + 1);
    stops[i].input = std::isfinite(to - from) ? from + (to - from) / pieces : lerp(from, to, 1 / pieces);
  }
}

double along(const std::vector<Stop>& stops, double t) {
  const auto after = std::upper_bound(stops.begin() + 1, stops.end() - 1, t,
                                      [](double input, const Stop& stop) { return input < *stop.input; });
  const Stop &from = after[-1], &to = *after;
  if (!(*from.input < *to.input)) return to.output;
  const double part = part_between(*from.input, *to.input, t);
  return (1 - part) * from.output + part * to.output;
}

}  // namespace

Easing cubic_bezier(double x1, double y1, double x2, double y2) {
  require_in(0, 1, "cubic-bezier's x1", x1, "must be in 0 .. 1");
  require_in(0, 1, "cubic-bezier's x2", x2, "must be in 0 .. 1");
  require_in(-1e6, 1e6, "cubic-bezier's y1", y1, "must be at most 1e6 in size");
  require_in(-1e6, 1e6, "cubic-bezier's y2", y2, "must be at most 1e6 in size");
  return [=](double t) { return cubic(y1, y2, parameter_of(x1, x2, t)); };
}

Easing steps(int n, Jump jump) {
  if (n < 1) refuse("steps", n, "must be one or more");
  if (n == 1 && jump == Jump::none) refuse("steps 1", "must be two or more where it jumps at neither end");
  const double first = jump == Jump::start || jump == Jump::both ? 1 : 0;
  const double jumps = n + (jump == Jump::both ? 1.0 : jump == Jump::none ? -1.0 : 0.0);
  return {[=](double t) { return std::min(1.0, (std::floor(t * n) + first) / jumps); }, {}};
}

Easing linear_through(std::vector<Stop> stops) {
  if (stops.size() < 2) refuse("linear easing", "must have two corners or more");
  for (const Stop& stop : stops) {
    if (!std::isfinite(stop.output)) refuse("linear easing's output", stop.output, "must be finite");
    if (stop.input && !std::isfinite(*stop.input))
      refuse("linear easing's input", *stop.input, "must be finite");
  }
  fill_inputs(stops);
  const Easing sampled([stops](double t) { return along(stops, t); });
  std::vector<double> turns = sampled.turns();
  for (const Stop& stop : stops)  // a corner may be too narrow for samples; one that is no turn does no harm
    if (*stop.input > 0 && *stop.input < 1) turns.push_back(*stop.input);
  std::sort(turns.begin(), turns.end());
  turns.erase(std::unique(turns.begin(), turns.end()), turns.end());
  return {[stops = std::move(stops)](double t) { return along(stops, t); }, std::move(turns)};
}

}  // namespace first_contact::ease
