#pragma once
#include <cstddef>
#include <limits>
#include <optional>
#include <ostream>

#include "first_contact/sweep/moving.hpp"

/// \file
/// One verb, one answer: `sweep(moving, obstacle)` gives the first contact of a motion, if there is one.
///
/// The contract of every sweep:
/// - Motion is S(t) = S0 + t V for t in [0, 1]; lengths are in one unit of the caller's choice.
/// - Coordinates, radii and displacements are at most 2^1000 = 1.07e301 in size: larger ones are refused when
///   a shape or a motion is made. They may be as small as one likes, if the largest in a question is at least
///   2^-900 = 1e-271, for doubles below 2^-1022 have lost digits of their own. A scene multiplied by a power
///   of two has the same answer: the time to the last bit, the point multiplied by it. What is smaller than
///   the largest length by more than 2^80 may count as 0, unless it is said otherwise.
/// - Apart at 0: the first t in [0, 1] at which the distance is 0, or nothing.
/// - Touching at 0: a contact at t = 0 if approaching (V.N < 0), nothing if sliding along or leaving.
/// - Overlapping at 0: a contact at t = 0 if going deeper, nothing if leaving (so that one can get out).
///   Against a mesh this is judged feature by feature, for each face, edge and vertex that is nearer to the
///   centre than what of the surface lies around it. A centre on the obstacle itself has no normal of its
///   own: it is against the motion.
/// - No motion: nothing. `overlap(a, b)` answers the static question. A sphere of radius 0 is a point.
/// - The smallest t wins; of equal t, the face before the edge before the vertex, as the paper orders its
///   tests (2.1).
/// - Surfaces have two sides.
/// - No hit is missed by more than rounding: what goes deeper than the bound of error that is stated with each
///   sweep is hit, what stays farther away is not, and at seams between faces, edges and vertices nothing gets
///   through. The error of t has a bound, stated there too.
/// - Bad shapes and motions are refused when they are made; a sweep itself never throws.
/// - The same question has the same answer, to the last bit: wherever its numbers lie in memory, whatever the
///   compiler, its optimization and its vector instructions, on x86-64, ARM64 and WebAssembly. Each sum is
///   made in an order that is written down, and nothing is rounded but by IEEE 754's own operations. Meshes
///   that turn are the exception: their sines are the C library's.
/// \see tests/digest/, tests/unit/same_bits.cpp

namespace first_contact {

/// What of a polyhedron is touched. A plane and a sphere have but one smooth face.
enum class Feature { face, edge, vertex };

/// "face", "edge" or "vertex".
constexpr const char* to_string(Feature feature) {
  return feature == Feature::face ? "face" : feature == Feature::edge ? "edge" : "vertex";
}

/// Writes "face", "edge" or "vertex".
inline std::ostream& operator<<(std::ostream& out, Feature feature) { return out << to_string(feature); }

/// The points of one contact, one a column: 1 as a rule; 2 or 4 when a box lands on an edge or a face.
using ContactPoints = Eigen::Matrix<double, 3, Eigen::Dynamic, unaligned, 3, 4>;

/// One point as the points of a contact. (Made by its column: of a copy in one piece, g++ 12 for AVX-512 says
/// that it reads eight numbers where there are three.)
inline ContactPoints only(const Point& point) {
  ContactPoints points(3, 1);
  points.col(0) = point;
  return points;
}

/// The number of no triangle.
inline constexpr std::size_t no_triangle = std::numeric_limits<std::size_t>::max();

//! [contact]
/// The first contact of a sweep.
struct Contact {
  double time;           ///< t in [0, 1] (or in the interval that was asked for)
  ContactPoints points;  ///< on the obstacle, at that time
  Vector normal;         ///< unit, from the obstacle to the mover, at that time
  Feature feature;       ///< what of the polyhedron is touched
  /// Of a mesh: the touched triangle, the lowest number if several share it.
  std::size_t triangle = no_triangle;

  /// The one point of the contact; of an edge or a face, its middle.
  Point point() const;
};
//! [contact]

}  // namespace first_contact
