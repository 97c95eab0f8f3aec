#pragma once
#include <string>

#include "rooms.hpp"

/// The scene of the paper's figure 10: a ball on its way from P1 to P2 meets a wall at Q.
struct Scene {
  std::string mesh;  ///< a file; without one, the wall of the figure, which lies level
  long terrain = 0;  ///< if not 0, a terrain of so many squares along each side instead
  first_contact::Point from{-2, -0.5, 2};
  first_contact::Point to{2, 0.5, -0.5};
  double radius = 0.5;
  first_contact::Vector wall{0, 0, 0};  ///< a second wall, which rises from the ground; zero: none

  /// \throws std::invalid_argument if the file is no mesh.
  first_contact::Environment environment() const;
  /// \throws std::invalid_argument if a coordinate of P2 - P1 is not finite.
  first_contact::Moving<first_contact::Sphere> ball() const { return {{from, radius}, to - from}; }
};
