#pragma once
#include <vector>

#include "dice.hpp"
#include "first_contact/geometry/box.hpp"
#include "first_contact/geometry/mesh.hpp"
#include "first_contact/geometry/plane.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/geometry/transform.hpp"
#include "first_contact/geometry/triangle.hpp"
#include "first_contact/sweep/contact.hpp"

namespace digest {

using namespace first_contact;

/// What touches, almost touches, grazes, is thin or degenerate, each in the unit of its scene.
Plane plane(Dice& dice, double unit);
Box box(Dice& dice, double unit);
Triangle triangle(Dice& dice, double unit);
/// Its path aims at a place near the origin, or just beside it.
Moving<Sphere> ball(Dice& dice, double unit);
/// A ball that at t = 0 or later is as far from a point as its radius is, up to a few last bits.
Moving<Sphere> grazing_ball(Dice& dice, const Point& target, double unit);
/// A turn by a quaternion of small whole numbers: no sine.
Rigid turn(Dice& dice);

/// A ground of 2 n^2 triangles over [-2, 2]^2: level, stepped or rough.
Mesh ground(Dice& dice, int n, double unit);
/// Triangles that have nothing to do with each other.
std::vector<Triangle> soup(Dice& dice, int n, double unit);

}  // namespace digest
