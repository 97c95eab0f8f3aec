#pragma once
#include <vector>

#include "first_contact/motion/easing.hpp"
#include "first_contact/sweep/interval.hpp"

namespace first_contact {

/// A span of time in which an easing only rises, or only falls.
struct OneWay {
  ///@{
  /// Ascending.
  double from_time, to_time;
  ///@}
  ///@{
  /// Of the way, at these times.
  double from_part, to_part;
  ///@}
};

/// The clock of one leg: which part of the way is done at which time, and the other way round.
class Timing {
 public:
  /// It must begin before it ends, and both times be finite.
  Timing(Easing easing, double begin, double end);

  /// The part of the way that is done at a time: exactly 0 at the leg's beginning and 1 at its end.
  double part_at(double time) const;
  /// The spans of time within an interval in which the way goes on, or back, one after the other.
  std::vector<OneWay> ways(const Interval& clock) const;
  /// When that part of the way is come to: the first time if the part is exactly reached, or else the last time
  /// before that. Found by halving, to the last bit.
  double time_of(double part, const OneWay& way) const;

 private:
  Easing easing_;
  double begin_, end_;
};

}  // namespace first_contact
