#include "first_contact/motion/timing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "first_contact/geometry/space.hpp"

namespace first_contact {

Timing::Timing(Easing easing, double begin, double end)
    : easing_(std::move(easing)), begin_(begin), end_(end) {}

//! [tween_part]
// Two times far apart are halved first, for their difference may overflow; others are not, for a tiny one may vanish.
double Timing::part_at(double time) const {
  const double all = end_ - begin_;
  if (std::isfinite(all)) return easing_((time - begin_) / all);
  return easing_((time / 2 - begin_ / 2) / (end_ / 2 - begin_ / 2));
}
//! [tween_part]

std::vector<OneWay> Timing::ways(const Interval& clock) const {
  const double first = std::max(begin_, clock.first), last = std::min(end_, clock.last);
  std::vector<OneWay> all;
  if (!(first < last)) return all;
  std::vector<double> times{first};
  for (const double turn : easing_.turns())
    if (const double time = lerp(begin_, end_, turn); time > times.back() && time < last)
      times.push_back(time);
  times.push_back(last);
  for (std::size_t i = 1; i < times.size(); ++i)
    all.push_back({times[i - 1], times[i], part_at(times[i - 1]), part_at(times[i])});
  return all;
}

//! [time_of]
double Timing::time_of(double part, const OneWay& way) const {
  const bool rises = way.from_part < way.to_part;
  const auto has_come = [&](double time) { return rises ? part_at(time) >= part : part_at(time) <= part; };
  double before = way.from_time, after = way.to_time;
  if (has_come(before)) return before;
  for (;;) {
    const double middle = before / 2 + after / 2;
    if (!(middle > before && middle < after)) break;
    (has_come(middle) ? after : before) = middle;
  }
  return part_at(after) == part ? after : before;
}
//! [time_of]

}  // namespace first_contact
