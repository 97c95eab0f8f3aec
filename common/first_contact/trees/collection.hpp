#pragma once
#include <concepts>
#include <span>
#include <utility>
#include <vector>

#include "first_contact/geometry/mesh.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"
#include "first_contact/trees/ball_search.hpp"
#include "first_contact/trees/box_search.hpp"
#include "first_contact/trees/search.hpp"

namespace first_contact {

/// Many objects and the tree that finds them: triangles (`Soup<Octree>`), or objects of any shape that are
/// known by their bounds (`Objects<Octree>`).
template <class Object, Partition Tree>
class Collection {
 public:
  /// \param limits  passed on to the tree
  template <class... Limits>
  explicit Collection(std::vector<Object> all, const Limits&... limits)
      : all_(std::move(all)), tree_(std::span<const Object>(all_), limits...) {
    for (const Object& object : all_) bounds_.extend(bounds_of(object));
  }
  /// The triangles of a mesh, each for itself.
  /// \param limits  passed on to the tree
  template <class... Limits>
  requires std::same_as<Object, Triangle>
  explicit Collection(const Mesh& mesh, const Limits&... limits) : Collection(mesh.triangles(), limits...) {}

  /// All of them.
  const std::vector<Object>& all() const { return all_; }
  /// What finds them.
  const Tree& tree() const { return tree_; }
  /// The bounds of all.
  const Bounds& bounds() const { return bounds_; }

 private:
  std::vector<Object> all_;
  Tree tree_;
  Bounds bounds_;
};

/// Searches a collection.
/// \param counted if given, it is told what the search did
template <class Object, Partition Tree>
void ask(const Collection<Object, Tree>& collection, Search& question, Statistics* counted) {
  collection.tree().search(question);
  if (counted) *counted = question.statistics();
}

/// Which objects share a point with a box?
template <class Object>
class NearBox : public BoxSearch {
 public:
  /// \param scene the bounds of all objects
  NearBox(const Bounds& box, std::span<const Object> all, const Bounds& scene)
      : BoxSearch(box, scene), all_(all) {}

 private:
  bool hit(std::size_t i) override { return overlap(all_[i], box()); }

  std::span<const Object> all_;
};

/// Which objects would a moving ball touch if no other were there? Of what is known by its bounds: which
/// could it?
template <class Object>
class NearBall : public BallSearch {
 public:
  /// \param scene the bounds of all objects
  NearBall(const Moving<Sphere>& ball, std::span<const Object> all, const Bounds& scene)
      : BallSearch(ball, scene), all_(all) {}

 private:
  bool hit(std::size_t i) override { return is_near(all_[i]); }
  bool is_near(const Triangle& triangle) const { return sweep(ball(), triangle).has_value(); }
  bool is_near(const Bounds& box) const { return reaches(box); }

  std::span<const Object> all_;
};

/// The numbers of all objects that share a point with the box; of what is known by its bounds, whose bounds
/// do.
/// \param counted if given, it is told what the search did
template <class Object, Partition Tree>
std::vector<std::size_t> near(const Bounds& box, const Collection<Object, Tree>& collection,
                              Statistics* counted = nullptr) {
  NearBox<Object> question(box, collection.all(), collection.bounds());
  ask(collection, question, counted);
  return question.found();
}

/// The numbers of all triangles that the moving sphere would touch if no other were there; or of all objects
/// whose bounds, moved out by the radius, its centre meets: every object that it could touch is among them.
/// \param counted if given, it is told what the search did
template <class Object, Partition Tree>
std::vector<std::size_t> near(const Moving<Sphere>& ball, const Collection<Object, Tree>& collection,
                              Statistics* counted = nullptr) {
  NearBall<Object> question(ball, collection.all(), collection.bounds());
  ask(collection, question, counted);
  return question.found();
}

}  // namespace first_contact
