#pragma once
#include <vector>

#include "first_contact/program/accuracy.hpp"
#include "first_contact/program/program.hpp"

/// How far the answers can be trusted: measured, in single and in double precision.

namespace general_sphere_chapter {

/// How the cylinder about an edge is met: as books have it, or by way of the closest approach.
enum class EdgeFormula { textbook, stable };

/// A ball is flung at the middle of an edge, two radii long, from 10^(1/2), 10, 10^(3/2) ... radii away, up
/// to 10^10 or as far as the precision can tell neighbouring places apart. It is aimed up to 0.9 r beside the
/// edge: all should hit. The errors are those of t, relative to it. The truth for each is computed on the
/// same numbers with twice the digits of a double.
template <class Scalar>
std::vector<first_contact::program::Accuracy> accuracy_at_an_edge(EdgeFormula formula);

/// How a ray and a triangle are tested.
enum class RayTest {
  determinant,  ///< no hit if a determinant is less than 1e-5 (after Moeller and Trumbore)
  areas,        ///< a hit if three areas differ by less than 1e-5 from the whole
  weights       ///< this library's: no tolerance at all
};

/// Many rays at triangles of one size.
struct Wrong {
  double size;   ///< of the triangles, and of the motions with them
  double share;  ///< of the answers that are wrong: hits that are lost, and misses that are called hits
};

/// Half of the rays are aimed into a triangle and half beside it, a twentieth of its height or more from its
/// sides; the triangles are 10^-6 to 10^6 in size, in steps of a quarter of a decade.
template <class Scalar>
std::vector<Wrong> wrong_answers(RayTest test);

/// Numbers that the notes speak of.
void note_accuracy(first_contact::program::Program& program);

}  // namespace general_sphere_chapter
