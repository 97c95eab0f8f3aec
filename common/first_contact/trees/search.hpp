#pragma once
#include <concepts>
#include <cstddef>
#include <utility>
#include <vector>

#include "first_contact/geometry/bounds.hpp"
#include "first_contact/geometry/plane.hpp"

/// \file
/// The seam between trees and questions. A tree knows where its objects are; a search knows what is asked.
/// The tree hands itself over, node by node; the search says which nodes it reaches, tests the objects there,
/// and counts. So each question is written once for all trees, and each tree once for all questions.

namespace first_contact {

/// What a search did.
struct Statistics {
  std::size_t nodes = 0;  ///< nodes that were looked at
  std::size_t depth = 0;  ///< the depth of the deepest of them; the root's is 0
  std::size_t tests = 0;  ///< objects that were themselves tested, each at most once
  std::size_t hits = 0;   ///< objects that passed their test

  /// Are all four counts equal?
  bool operator==(const Statistics&) const = default;
};

/// The parts of a motion before and behind a plane, as far as the search reaches: while it straddles the
/// plane, it is in both.
struct Sides {
  /// Before the plane.
  Passage front;
  /// Behind it.
  Passage back;

  /// Does it reach the plane itself?
  bool both() const { return !front.empty() && !back.empty(); }
};

//! [search]
/// A question, asked of a tree. Each kind of question says which boxes and sides it reaches, and when an
/// object is hit.
class Search {
 public:
  Search() = default;
  Search(const Search&) = delete;
  Search& operator=(const Search&) = delete;
  virtual ~Search() = default;

  /// Could an object within this box be hit?
  virtual bool reaches(const Bounds& box) const = 0;
  /// On which sides of the plane could an object be hit in this part of the motion? (paper, 1.4)
  virtual Sides sides(const Plane& plane, const Passage& part) const = 0;
  /// Where the motion goes, so that a tree may show what is nearer first: about 1 long, or zero if that does not
  /// matter.
  virtual Vector heading() const { return Vector::Zero(); }

  /// Counts a node that is looked at.
  void count_node(std::size_t depth);
  /// Tests an object. A tree offers each object at most once.
  void test(std::size_t object);

  /// The objects that passed the test, in ascending order.
  std::vector<std::size_t> found() const;
  /// What has been counted so far.
  const Statistics& statistics() const { return statistics_; }

 private:
  // Is the object of that number hit?
  virtual bool hit(std::size_t object) = 0;

  std::vector<std::size_t> found_;
  Statistics statistics_;
};
//! [search]

/// A structure that finds objects, numbered from 0: an octree, a BSP tree, or none at all.
template <class Tree>
concept Partition = requires(const Tree& tree, Search& search) {
  tree.search(search);  // shows the search at least every object that it could hit
  { tree.nodes() } -> std::convertible_to<std::size_t>;
  { tree.depth() } -> std::convertible_to<std::size_t>;
  { tree.work() } -> std::convertible_to<std::size_t>;
};

}  // namespace first_contact
