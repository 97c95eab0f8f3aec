#include "growth.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "first_contact/geometry/bounds.hpp"
#include "first_contact/pairs/first_contacts.hpp"
#include "first_contact/program/random.hpp"

using namespace first_contact;
using program::uniform;

namespace {

Vector vector(std::mt19937& random, double size) {
  Vector v;
  for (double& x : v) x = size * uniform(random);
  return v;
}

//! [one_axis]
// Sort all motions by where they begin along x: each need only be tested against those that begin before it
// ends. In space, what overlaps along x is a whole slice: of n spheres, some n^(2/3).
std::size_t pairs_along_one_axis(const std::vector<Moving<Sphere>>& spheres) {
  std::vector<double> begins, ends;
  for (const auto& sphere : spheres) {
    const Bounds bounds = bounds_of(sphere.shape, sphere.displacement);
    begins.push_back(bounds.min().x());
    ends.push_back(bounds.max().x());
  }
  std::sort(begins.begin(), begins.end());
  std::size_t pairs = 0;
  for (const double end : ends)
    pairs += static_cast<std::size_t>(std::upper_bound(begins.begin(), begins.end(), end) - begins.begin());
  // Counted are all that begin before this one ends; taken off again those that begin before it, and itself.
  const std::size_t n = spheres.size();
  return pairs - n * (n + 1) / 2;
}
//! [one_axis]

}  // namespace

//! [crowd]
std::vector<Moving<Sphere>> crowd(std::size_t count, Crowd kind) {
  std::mt19937 random(1);
  const double side = std::cbrt(static_cast<double>(count));
  std::vector<Moving<Sphere>> spheres;
  for (std::size_t i = 0; i < count; ++i) {
    const bool fast = kind == Crowd::uneven && i % 100 == 1;
    const Point center = vector(random, side / 2);
    const double radius = 0.2 + 0.1 * uniform(random);
    spheres.push_back({{center, radius}, vector(random, fast ? 10 : 1)});
  }
  if (kind == Crowd::uneven && count > 0) spheres[0].shape.radius = side;
  return spheres;
}
//! [crowd]

//! [work]
Work work(std::size_t count, Crowd kind) {
  const auto spheres = crowd(count, kind);
  PairStatistics counted;
  const std::size_t contacts = first_contacts(spheres, &counted).size();
  return {count,         count * (count - 1) / 2, pairs_along_one_axis(spheres),
          counted.boxes, counted.sweeps,          contacts};
}
//! [work]
