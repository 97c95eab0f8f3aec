#pragma once
#include <cmath>

#include "first_contact/geometry/number_text.hpp"
#include "first_contact/geometry/refuse.hpp"

namespace first_contact {

/// A span of time t_m .. t_n, both ends included (paper, 2.3); it may begin before 0 and end after 1.
struct Interval {
  /// \throws std::invalid_argument if an end is not finite, or the first comes after the last.
  Interval(double t_m, double t_n) : first(t_m), last(t_n) {
    if (std::isfinite(first) && std::isfinite(last) && first <= last) return;
    refuse("interval " + to_text(first) + ", " + to_text(last), "both ends must be finite, and in order");
  }

  ///@{
  /// t_m, and t_n.
  double first, last;
  ///@}
};

}  // namespace first_contact
