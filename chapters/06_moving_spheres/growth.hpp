#pragma once
#include <cstddef>
#include <vector>

#include "first_contact/geometry/sphere.hpp"
#include "first_contact/sweep/contact.hpp"

/// How the work grows with the number of spheres, when every two of them may meet: counted, not timed.

/// Spheres about alike in size and speed; or with one as large as all of space, and one in a hundred ten
/// times as fast.
enum class Crowd { alike, uneven };

/// Spheres spread at random over a cube, as dense for any number of them: on average one in a cube of side 1,
/// with radii from 0.1 to 0.3 and motions of up to 1 along each axis.
std::vector<first_contact::Moving<first_contact::Sphere>> crowd(std::size_t count, Crowd kind);

/// The work for one number of spheres.
struct Work {
  std::size_t spheres;     ///< n
  std::size_t every_pair;  ///< n (n - 1) / 2
  std::size_t one_axis;    ///< pairs that "sweep and prune" along x leaves to be tested
  std::size_t boxes;       ///< tests of boxes by first_contacts()
  std::size_t sweeps;      ///< pairs that first_contacts() sweeps
  std::size_t contacts;    ///< pairs that meet
};

/// Counts it.
Work work(std::size_t count, Crowd kind);
