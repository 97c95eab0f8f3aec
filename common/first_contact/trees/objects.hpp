#pragma once
#include <span>
#include <utility>
#include <vector>

#include "first_contact/trees/ball_search.hpp"
#include "first_contact/trees/box_search.hpp"
#include "first_contact/trees/search.hpp"

namespace first_contact {

/// Many objects of any shape, known by their bounds, and the tree that finds them: `Objects<Octree>`,
/// `Objects<BruteForce>`.
template <Partition Tree>
class Objects {
 public:
  /// \param limits  passed on to the tree
  template <class... Limits>
  explicit Objects(std::vector<Bounds> all, const Limits&... limits)
      : all_(std::move(all)), tree_(std::span<const Bounds>(all_), limits...), bounds_(bounds_of(all_)) {}

  /// The bounds of each object.
  const std::vector<Bounds>& all() const { return all_; }
  /// What finds them.
  const Tree& tree() const { return tree_; }
  /// The bounds of all.
  const Bounds& bounds() const { return bounds_; }

 private:
  std::vector<Bounds> all_;
  Tree tree_;
  Bounds bounds_;
};

/// The numbers of all objects whose bounds overlap the box.
template <Partition Tree>
std::vector<std::size_t> near(const Bounds& box, const Objects<Tree>& objects,
                              Statistics* counted = nullptr) {
  BoxSearch search(box, objects.bounds(), [&](std::size_t i) { return overlap(box, objects.all()[i]); });
  objects.tree().search(search);
  if (counted) *counted = search.statistics();
  return search.found();
}

/// The numbers of all objects whose bounds, moved out by the radius, the centre of the moving sphere meets:
/// every object that it could touch is among them.
template <Partition Tree>
std::vector<std::size_t> near(const Moving<Sphere>& ball, const Objects<Tree>& objects,
                              Statistics* counted = nullptr) {
  const BallSearch* self = nullptr;
  BallSearch search(ball, objects.bounds(), [&](std::size_t i) { return self->reaches(objects.all()[i]); });
  self = &search;
  objects.tree().search(search);
  if (counted) *counted = search.statistics();
  return search.found();
}

//! [pairs]
/// All pairs of objects whose bounds overlap, the lower number first, in ascending order.
template <Partition Tree>
std::vector<std::pair<std::size_t, std::size_t>> pairs(const Objects<Tree>& objects) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (std::size_t i = 0; i < objects.all().size(); ++i)
    for (const std::size_t j : near(objects.all()[i], objects))
      if (i < j) found.emplace_back(i, j);
  return found;
}
//! [pairs]

}  // namespace first_contact
