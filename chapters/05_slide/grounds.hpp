#pragma once
#include <functional>
#include <vector>

#include "first_contact/bvh/bvh.hpp"
#include "first_contact/geometry/mesh.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/program/language.hpp"
#include "first_contact/program/random.hpp"

namespace walks {

using namespace first_contact;

//! [ground]
/// A surface, a ball that is set down on it, and what it wishes in each frame.
struct Ground {
  program::Text name;
  Mesh mesh;
  Sphere ball;   ///< where it is set down, and again when it has come too far from there
  double reach;  ///< how far that is, along any axis
  std::function<Vector(program::Random&)>
      way;  ///< that it wishes to go for the next frames; its length is the speed
  std::function<Vector(const Point&)> pull;  ///< that is added from where it is, in units of the speed
  std::function<bool(const Point&, const Bvh&)> on_its_side;  ///< is a centre where no wall keeps it out?
  Vector still = Vector::Zero();  ///< 1 for each coordinate that must not change once the ball lies still
};
//! [ground]

/// Terrain of 20,000 triangles, the bunny, and a room with a ramp and two steps: the ball wanders, slow to
/// two radii per frame. Then a level floor of 20,000 triangles, along which it is pushed, and an upright
/// wedge of 30 degrees, into which it is pushed.
std::vector<Ground> grounds();

}  // namespace walks
