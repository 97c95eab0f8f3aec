#pragma once
#include <optional>

#include "first_contact/geometry/space.hpp"

namespace general_sphere_chapter {

/// The entry into a sphere about a vertex, in numbers of one kind.
struct Entered {
  double minus_b, root;            ///< as multiplied out: what is subtracted
  std::optional<double> textbook;  ///< (-b - root) / a
  std::optional<double> stable;    ///< by way of the closest approach
};

/// A ball of radius 1 comes from afar, along x, by twice its distance from a vertex at the origin.
struct FromAfar {
  first_contact::Point from;
  first_contact::Vector way;
  Entered in_float, in_double;
};

/// \param distance  from which it comes
/// \param beside  how far beside the vertex it is aimed
FromAfar from_afar(double distance, double beside);

}  // namespace general_sphere_chapter
