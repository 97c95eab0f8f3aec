#pragma once
#include <vector>

/// What becomes of the two formulas for the time of contact when the spheres come from far away: measured.

/// The arithmetic and the formula.
enum class Formula { textbook, closest_approach };

/// Many random hits from one distance.
struct FarAway {
  double distance;  ///< from which the spheres come, in units of d = r_P + r_Q
  double error;     ///< the median of how far off the contact is, in units of d; infinite if most are lost
  double lost;      ///< the share of the hits that were not found
};

/// Spheres are shot at each other from 1, 10^(1/2), 10 ... times d, up to 10^10 or as far as the precision
/// can tell them apart, aimed up to 0.9 d beside each other's centre: all should hit. The truth for each is
/// computed on the same numbers in extended precision.
template <class Scalar>
std::vector<FarAway> measure(Formula formula);
