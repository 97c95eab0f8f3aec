#pragma once
#include "first_contact/trees/search.hpp"

namespace first_contact {

/// A box among objects: which does it touch?
class BoxSearch : public Search {
 public:
  /// \param scene the bounds of all objects
  BoxSearch(const Bounds& box, const Bounds& scene);

  bool reaches(const Bounds& box) const override { return overlap(box_, box); }
  /// A box at rest is in front of a plane if E.Q > r_eff, and behind it if E.Q < -r_eff (paper, 1.3, 1.4).
  Sides sides(const Plane& plane, const Passage& part) const override;

 protected:
  /// What is looked around in.
  const Bounds& box() const { return box_; }

 private:
  Bounds box_;
  double margin_;
};

}  // namespace first_contact
