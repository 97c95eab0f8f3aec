#pragma once
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "first_contact/sweep/sphere_triangle.hpp"
#include "first_contact/trees/box_search.hpp"
#include "first_contact/trees/cast.hpp"
#include "first_contact/trees/search.hpp"

namespace first_contact {

/// Many triangles, each for itself, and the tree that finds them: `Soup<Octree>`, `Soup<BspTree>`,
/// `Soup<BruteForce>`. (Triangles that make up a surface are an environment, chapter 4: there an edge between
/// two faces is judged by both.)
template <Partition Tree>
class Soup {
 public:
  /// \param limits  passed on to the tree
  template <class... Limits>
  explicit Soup(std::vector<Triangle> triangles, const Limits&... limits)
      : triangles_(std::move(triangles)), tree_(std::span<const Triangle>(triangles_), limits...) {
    for (const Triangle& triangle : triangles_) bounds_.include(bounds_of(triangle));
  }

  /// All triangles.
  const std::vector<Triangle>& triangles() const { return triangles_; }
  /// What finds them.
  const Tree& tree() const { return tree_; }
  /// The bounds of all.
  const Bounds& bounds() const { return bounds_; }

 private:
  std::vector<Triangle> triangles_;
  Tree tree_;
  Bounds bounds_;
};

//! [sweep_soup]
/// First contact of a moving sphere with many triangles: the smallest t over all; of equal t the face before
/// the edge before the vertex, then the triangle with the lowest number. Bit for bit the same for every tree,
/// as long as rounding moves a contact by less than `search_margin` along the motion.
/// \param counted if given, it is told what the search did
template <Partition Tree>
std::optional<Contact> sweep(const Moving<Sphere>& ball, const Soup<Tree>& soup,
                             Statistics* counted = nullptr) {
  Cast cast(ball, soup.triangles(), soup.bounds());
  soup.tree().search(cast);
  if (counted) *counted = cast.statistics();
  return cast.contact();
}
//! [sweep_soup]

/// The numbers of all triangles that the moving sphere would touch if no other were there.
template <Partition Tree>
std::vector<std::size_t> near(const Moving<Sphere>& ball, const Soup<Tree>& soup,
                              Statistics* counted = nullptr) {
  BallSearch all(ball, soup.bounds(),
                 [&](std::size_t i) { return sweep(ball, soup.triangles()[i]).has_value(); });
  soup.tree().search(all);
  if (counted) *counted = all.statistics();
  return all.found();
}

/// The numbers of all triangles that share a point with the box.
template <Partition Tree>
std::vector<std::size_t> near(const Bounds& box, const Soup<Tree>& soup, Statistics* counted = nullptr) {
  BoxSearch all(box, soup.bounds(), [&](std::size_t i) { return overlap(soup.triangles()[i], box); });
  soup.tree().search(all);
  if (counted) *counted = all.statistics();
  return all.found();
}

}  // namespace first_contact
