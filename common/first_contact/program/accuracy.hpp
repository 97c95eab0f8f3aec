#pragma once
#include <limits>
#include <vector>

/// \file
/// How far the answers of a formula can be trusted: what many shots from one distance came to.

namespace first_contact::program {

/// The error of a shot that should hit and is not found to.
inline constexpr double lost_shot = std::numeric_limits<double>::infinity();

/// Many shots from one distance, all of which should hit.
struct Accuracy {
  double distance;  ///< from which they come
  double error;     ///< the median of their errors; infinite if most are lost
  double lost;      ///< the share of those that were not found
};

/// \param errors  of the shots, `lost_shot` for what was not found; at least one
Accuracy accuracy(double distance, std::vector<double> errors);

}  // namespace first_contact::program
