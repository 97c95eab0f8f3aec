#pragma once
#include <array>
#include <optional>
#include <vector>

#include "first_contact/geometry/bounding.hpp"
#include "first_contact/program/language.hpp"
#include "first_contact/sweep/box_plane.hpp"

/// \file
/// The three small studies of chapter 2 that have a scene of their own: the report prints them, the figures
/// draw them.

namespace box_chapter {

using first_contact::Box;
using first_contact::Contact;
using first_contact::Point;
using first_contact::Sphere;
using first_contact::Vector;
using first_contact::program::Text;

/// One and the same brick, laid level, turned about one axis, and turned about two; then dropped on the
/// floor.
struct Landing {
  Text name;
  Box box;  ///< at the time of contact
  Contact contact;
};
std::array<Landing, 3> landings();

/// A level brick and its floor, both turned by one rotation: which of its axes are parallel to the floor?
struct TurnedTogether {
  int exact_zeros;       ///< of R.N, S.N, T.N, as the paper asks for
  int within_tolerance;  ///< parallel to within rounding, as the library does
  Vector slopes;         ///< R.N / |R| and so on, as computed
  double corner_off;     ///< from the corner that the paper would report to the middle of the face that lands
};
TurnedTogether turned_together();

/// A box before the eye of a camera, and the plane of the frustum that it is farthest behind.
struct Sight {
  Text name;
  Box box;
  std::size_t plane;  ///< left, right, bottom, top, near, far
  double distance;    ///< E.Q
  double radius;      ///< r_eff
  bool rejected;
};
Sight sight_of(const Text& name, const Box& box);
std::vector<Sight> sights();

/// A shape, given by points on its surface, and its three bounding shapes.
struct Bounded {
  Text name;
  double volume;
  std::vector<Point> points;
  Sphere sphere;
  Box upright, turned;
};
std::array<Bounded, 3> bounded_shapes();

/// How many times as often a random plane meets the bounding shape as the shape itself: the ratio of their
/// mean widths (Cauchy), over many directions.
double more_often(const Sphere& sphere, const std::vector<Point>& points);
double more_often(const Box& box, const std::vector<Point>& points);

/// How many multiplications the test of one plane takes, counted: half of each axis is kept, not all of it.
struct Multiplications {
  int sphere, upright, turned;
};
Multiplications multiplications();

/// A number with that many digits after the point: enough for a comparison.
std::string rounded(double value, int digits = 2);

}  // namespace box_chapter
