#pragma once
#include "first_contact/trees/search.hpp"

namespace first_contact {

/// No structure at all: one node that holds every object. What the trees are measured against, and what they
/// must agree with.
class BruteForce {
 public:
  /// Of that many objects.
  explicit BruteForce(std::span<const Bounds> objects) : size_(objects.size()) {}
  /// Of that many polygons.
  explicit BruteForce(std::span<const Triangle> polygons) : size_(polygons.size()) {}

  /// Offers every object to the search.
  void search(Search& search) const {
    search.count_node(0);
    for (std::size_t i = 0; i < size_; ++i) search.test(i);
  }
  /// One.
  std::size_t nodes() const { return 1; }
  /// Of a single node: 0.
  std::size_t depth() const { return 0; }
  /// None was needed: 0.
  std::size_t work() const { return 0; }

 private:
  std::size_t size_;
};

static_assert(Partition<BruteForce>);

}  // namespace first_contact
