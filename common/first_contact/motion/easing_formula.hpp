#pragma once

/// \file
/// The formulas of those easings that have parameters, for t inside of (0, 1).

namespace first_contact::ease::formula {

/// (2^bt - 1) / (2^b - 1). \see ease::exponential
double exponential(double t, double b = 10);
/// t^2 ((s + 1) t - s). \see ease::back
double back(double t, double overshoot = 1.70158);
/// Growing swings. \see ease::elastic
double elastic(double t, double amplitude = 1, double period = 0.3);
/// A damped harmonic oscillation from 0, at rest, towards 1. \see ease::spring
double spring(double t, double cycles, double damping);

}  // namespace first_contact::ease::formula
