#pragma once
#include "first_contact/trees/search.hpp"

namespace first_contact {

/// A box among objects: which does it touch?
class BoxSearch : public Search {
 public:
  /// \param scene the bounds of all objects;
  /// \param test of one object
  BoxSearch(const Bounds& box, const Bounds& scene, std::function<bool(std::size_t)> test);

  bool reaches(const Bounds& box) const override { return overlap(box_, box); }
  /// A box at rest is in front of a plane if E.Q > r_eff, and behind it if E.Q < -r_eff (paper, 1.3, 1.4).
  Sides sides(const Plane& plane, const Passage& part) const override;

 private:
  Bounds box_;
  double margin_;
};

}  // namespace first_contact
