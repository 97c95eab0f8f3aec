#pragma once
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "first_contact/geometry/mesh.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/sweep/contact.hpp"

/// \file
/// The ways to sweep a sphere that are measured against each other: ours, and those of other engines, each in
/// a file of its own that is built if the engine is found.

namespace peers {

using namespace first_contact;

inline constexpr double never = std::numeric_limits<double>::infinity();

/// One way, made ready for one mesh.
struct Way {
  std::string name;
  /// The time of the first contact of each cast, or never.
  std::function<void(std::span<const Moving<Sphere>>, std::span<double>)> sweep;
  bool of_spheres =
      true;  ///< false for the ray of a centre, of which no hit can be expected to be a sphere's
  std::size_t most_triangles = std::numeric_limits<std::size_t>::max();  ///< larger meshes take it too long
};

/// A way that takes one cast after the other.
template <class Sweep>
Way one_by_one(std::string name, Sweep sweep) {
  return {std::move(name),
          [sweep = std::move(sweep)](std::span<const Moving<Sphere>> casts, std::span<double> times) {
            for (std::size_t i = 0; i < casts.size(); ++i) times[i] = sweep(casts[i]);
          }};
}

using MakeWay = Way (*)(const Mesh&);

/// What makes the other engines' ways. A peer's file adds its own: `const Entry entry(make);`
inline std::vector<MakeWay>& engines() {
  static std::vector<MakeWay> all;
  return all;
}
struct Entry {
  explicit Entry(MakeWay make) { engines().push_back(make); }
};

/// Our ways: the yardstick first, to which all are compared.
std::vector<Way> own_ways(const Mesh& mesh);

}  // namespace peers
