#pragma once
#include <optional>
#include <vector>

#include "first_contact/motion/easing.hpp"

/// \file
/// The easings of style sheets (W3C, CSS Easing Functions Level 2), so that a film moves as a page does. All use
/// additions, products and quotients alone: they are the same on every machine.

namespace first_contact::ease {

/// The height of the cubic Bezier curve (0, 0), (x1, y1), (x2, y2), (1, 1) where its x is the part of the time. The
/// curve is solved for by halving, to the last bit of its parameter. `ease` is 0.25, 0.1, 0.25, 1; `ease-in` 0.42, 0,
/// 1, 1; `ease-out` 0, 0, 0.58, 1; `ease-in-out` 0.42, 0, 0.58, 1.
/// \throws std::invalid_argument if x1 or x2 is not in 0 .. 1, or y1 or y2 larger than 1e6 in size.
Easing cubic_bezier(double x1, double y1, double x2, double y2);

/// Where a staircase has its jumps: also at its start, at its end, at neither, or at both.
enum class Jump { start, end, none, both };

/// A staircase of n steps, all of the same length of time. As every easing it is 0 *at* 0: with `start` and `both` it
/// jumps right after that, where a style sheet has jumped already.
/// \throws std::invalid_argument if there is no step, or one alone that shall jump at neither end.
Easing steps(int n, Jump jump = Jump::end);

/// A corner of a chain of straight pieces: the part of the way, and the part of the time if it is given.
struct Stop {
  double output;  ///< of the way
  std::optional<double> input =
      std::nullopt;  ///< of the time; in the middle of its neighbours if it is left out
};

/// CSS's linear(): straight from corner to corner. Inputs that are left out are 0 for the first corner, 1 for the
/// last, and evenly spread between; one that is less than one before it is raised to that, so that it jumps there.
/// Before its first and after its last corner it goes straight on. As every easing it is 0 at 0 and 1 at 1.
/// \throws std::invalid_argument if there are fewer than two corners, or a number is not finite.
Easing linear_through(std::vector<Stop> stops);

}  // namespace first_contact::ease
