#pragma once
#include <cstddef>

/// \file
/// The loops behind a batch, compiled twice: for any processor, and for those with AVX2 and FMA. Which one
/// runs is decided when the program does.
///
/// This header is read by files that are compiled for different processors: plain data only, no functions
/// that a linker could take from the wrong one.

namespace first_contact::batch {

/// Where the numbers of many vectors stand.
struct Vectors {
  const double *x, *y, *z;
};

/// Where the numbers of many moving spheres stand.
struct Spheres {
  Vectors center;
  const double* radius;
  Vectors displacement;
};

/// Where the numbers of many moving boxes stand.
struct Boxes {
  Vectors center, r, s, t, displacement;
};

/// [N, D].
struct FlatPlane {
  double x, y, z, offset;
};

/// The three loops, for one kind of processor. Each writes `count` times.
struct Loops {
  void (*sphere_sphere)(const Spheres& p, const Spheres& q, std::size_t count, double* times);
  void (*sphere_plane)(const Spheres&, const FlatPlane&, std::size_t count, double* times);
  void (*box_plane)(const Boxes&, const FlatPlane&, std::size_t count, double* times);
};

/// Runs everywhere.
extern const Loops portable_loops;
/// Needs AVX2 and FMA; empty where the compiler does not know them.
extern const Loops avx2_loops;
/// Needs AVX-512 as well; empty where the compiler does not know it.
extern const Loops avx512_loops;

/// Does this processor have what they need?
bool can_run(const Loops& loops);
/// The fastest that it can run.
const Loops& best_loops();

}  // namespace first_contact::batch
