#pragma once

/// What becomes of the time of contact when the spheres nearly touch at the start: measured.

/// Medians of the relative error of t1, in single precision.
struct NearErrors {
  double by_difference;  ///< (-w.u - sqrt D) / u^2
  double by_product;     ///< (w^2 - d^2) / (-w.u + sqrt D)
};
/// \param gap  between the spheres, in units of d
NearErrors nearly_touching(double gap);
