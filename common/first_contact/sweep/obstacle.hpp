#pragma once
#include <concepts>
#include <functional>
#include <optional>
#include <type_traits>

#include "first_contact/geometry/sphere.hpp"
#include "first_contact/sweep/contact.hpp"

/// \file
/// What a motion can be swept against, and what the compiler says where a header is missing.

namespace first_contact {

class Bvh;
struct Box;
class Environment;
class Mesh;
class Plane;
struct Triangle;

/// Whatever a moving shape can be swept against: `sweep(moving, obstacle)` finds the first contact. Anybody's
/// type becomes one by a function of that name beside it.
template <class Any, class Shape = Sphere>
concept Obstacle = requires(const Moving<Shape>& moving, const Any& obstacle) {
  { sweep(moving, obstacle) } -> std::convertible_to<std::optional<Contact>>;
};

/// The first contact of a sphere with an environment of any kind.
using SphereSweep = std::function<std::optional<Contact>(const Moving<Sphere>&)>;

/// For messages of the compiler: which header is missing where two shapes of the library are put together.
namespace missing {

template <class Any, class... Types>
concept one_of = (std::same_as<Any, Types> || ...);

template <class Shape>
concept Mover = one_of<Shape, Sphere, Box>;

template <class Any>
concept Known = one_of<Any, Bvh, Box, Environment, Mesh, Plane, Sphere, Moving<Sphere>, Triangle>;

template <class Shape, class Any, class ShapeAsked, class AnyAsked>
concept are = std::same_as<Shape, ShapeAsked> && std::same_as<Any, AnyAsked>;

/// Never compiles: each line names a header, or a better way. The last is for pairs that nobody has written.
template <class Shape, class Any>
constexpr void say_which() {
  static_assert(
      !std::same_as<Any, Mesh>,
      "make an Environment or a Bvh of the mesh, once: to find its edges takes longer than many sweeps");
  static_assert(!are<Shape, Any, Sphere, Plane>, "include first_contact/sweep/sphere_plane.hpp");
  static_assert(!are<Shape, Any, Sphere, Triangle>, "include first_contact/sweep/sphere_triangle.hpp");
  static_assert(!are<Shape, Any, Sphere, Environment>, "include first_contact/sweep/sphere_mesh.hpp");
  static_assert(!are<Shape, Any, Sphere, Sphere>, "include first_contact/sweep/sphere_sphere.hpp");
  static_assert(!are<Shape, Any, Sphere, Moving<Sphere>>, "include first_contact/sweep/sphere_sphere.hpp");
  static_assert(!are<Shape, Any, Sphere, Box>, "include first_contact/sweep/sphere_box.hpp");
  static_assert(!are<Shape, Any, Sphere, Bvh>, "include first_contact/bvh/bvh.hpp");
  static_assert(!are<Shape, Any, Box, Plane>, "include first_contact/sweep/box_plane.hpp");
  static_assert(!are<Shape, Any, Box, Sphere>, "include first_contact/sweep/sphere_box.hpp");
  static_assert(!are<Shape, Any, Box, Box>, "include first_contact/sweep/box_box.hpp");
  static_assert(!are<Shape, Any, Box, Triangle>, "include first_contact/sweep/box_mesh.hpp");
  static_assert(!are<Shape, Any, Box, Environment>, "include first_contact/sweep/box_mesh.hpp");
  static_assert(!are<Shape, Any, Box, Bvh>, "a box is swept against an Environment, not against a Bvh");
  static_assert(!are<Shape, Any, Box, Moving<Sphere>>,
                "sweep the box, moving by the difference of both motions, against the sphere at rest");
  static_assert(!std::same_as<Shape, Shape>,
                "if no header is named above, this pair of shapes has no sweep yet");
}

}  // namespace missing

/// Chosen only where the header with the true answer is missing: says which, and compiles no further.
template <missing::Mover Shape, missing::Known Any>
std::optional<Contact> sweep(const Moving<Shape>&, const Any&) {
  missing::say_which<Shape, Any>();
  return std::nullopt;
}

/// The same for the static question.
template <missing::Mover Shape, missing::Known Any>
bool overlap(const Shape&, const Any&) {
  missing::say_which<Shape, std::conditional_t<std::same_as<Any, Mesh>, Environment, Any>>();
  return false;
}

/// First contact of a moving point with anything that a sphere can be swept against: a point is a sphere of
/// radius 0. The contract and the error are those of the sphere's sweep.
template <std::same_as<Point> Shape, Obstacle Any>
std::optional<Contact> sweep(const Moving<Shape>& moving, const Any& obstacle) {
  return sweep(Moving<Sphere>{Sphere{moving.shape, 0}, moving.displacement}, obstacle);
}

/// Is the point on the obstacle, or in it if it is solid? Exactly so: one that lies there but for a rounding
/// may be said to lie beside it.
template <std::same_as<Point> Shape, class Any>
requires requires(const Sphere& sphere, const Any& obstacle) { overlap(sphere, obstacle); }
bool overlap(const Shape& point, const Any& obstacle) { return overlap(Sphere{point, 0}, obstacle); }

}  // namespace first_contact
