#pragma once
#include <vector>

#include "first_contact/program/accuracy.hpp"

/// What becomes of the two formulas for the time of contact when the spheres come from far away: measured.

/// The arithmetic and the formula.
enum class Formula { textbook, closest_approach };

/// Spheres are shot at each other from 1, 10^(1/2), 10 ... times d, up to 10^10 or as far as the precision
/// can tell them apart, aimed up to 0.9 d beside each other's centre: all should hit. Distances, and errors
/// of the place of contact, are in units of d = r_P + r_Q. The truth for each is computed on the same numbers
/// in extended precision.
template <class Scalar>
std::vector<first_contact::program::Accuracy> measure(Formula formula);
