#pragma once
#include <Eigen/Core>

namespace first_contact {

/// On which side of the line from a to b is c? 1: on the left, so that a, b, c turn counterclockwise; -1: on
/// the right; 0: on the line itself. Exact: what rounding could decide is added up without any (J. R.
/// Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", 1997).
/// Needs: No coordinate is larger than 2^500, and none but 0 smaller than 2^-480.
int orientation(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);

}  // namespace first_contact
