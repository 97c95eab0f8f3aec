#pragma once
#include <vector>

#include "first_contact/motion/curve.hpp"

namespace tween_bounce {

/// A Bezier curve at a part of it, from 0 to 1: of its parameter, and of its length.
struct Bent {
  double length;                    ///< of the whole curve
  double speed;                     ///< |dC/ds| where its parameter is that part
  first_contact::Point point;       ///< there
  double even_parameter;            ///< where that part of the length is behind
  first_contact::Point even_point;  ///< there
};
Bent bent(const first_contact::Bezier& curve, double part);

/// What de Casteljau makes of the control points, one point fewer each time, down to the curve's own point.
std::vector<std::vector<first_contact::Point>> cut_corners(const first_contact::Bezier& curve,
                                                           double parameter);

}  // namespace tween_bounce
