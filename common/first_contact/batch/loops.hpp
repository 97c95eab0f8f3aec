#pragma once
#include <cstddef>

/// \file
/// The loops behind a batch. Each is compiled for several kinds of processor, and takes the best that is there
/// when the program runs; the library for that is Google's Highway.

namespace first_contact::batch {

/// Where the numbers of many vectors stand.
struct Vectors {
  ///@{
  /// A column for each coordinate.
  const double *x, *y, *z;
  ///@}
};

/// Where the numbers of many moving spheres stand.
struct Spheres {
  Vectors center;        ///< at t = 0
  const double* radius;  ///< not negative
  Vectors displacement;  ///< from t = 0 to t = 1
};

/// Where the numbers of many moving boxes stand.
struct Boxes {
  ///@{
  /// As in Box, and in Moving.
  Vectors center, r, s, t, displacement;
  ///@}
};

/// [N, D].
struct FlatPlane {
  ///@{
  /// N, of length 1, and D.
  double x, y, z, offset;
  ///@}
};

/// Writes `count` times: p[i] against q[i].
void sphere_sphere(const Spheres& p, const Spheres& q, std::size_t count, double* times);
/// Writes `count` times: each sphere against the plane.
void sphere_plane(const Spheres& spheres, const FlatPlane& plane, std::size_t count, double* times);
/// Writes `count` times: each box against the plane.
void box_plane(const Boxes& boxes, const FlatPlane& plane, std::size_t count, double* times);

}  // namespace first_contact::batch
