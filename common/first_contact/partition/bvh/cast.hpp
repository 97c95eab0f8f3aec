#pragma once
#include <optional>

#include "first_contact/partition/bvh/parts.hpp"
#include "first_contact/partition/bvh/verdict.hpp"

namespace first_contact::bvh {

/// One cast: a walk, which excludes, and a verdict, which decides.
class Cast {
 public:
  Cast(const Moving<Sphere>& moving, const Bvh::Parts& surface, const Walker& walk);

  /// Goes on to the end.
  void run();
  /// Goes on by one node or leaf. \returns whether there is more to do
  bool step();
  std::optional<Contact> contact() const { return verdict_.contact(); }

 private:
  bool enter(const Moving<Sphere>& moving, const Space& space);
  void decide();
  void consider(const Place& place);
  void note_latest();

  const Bvh::Parts& parts_;
  const Walker& walker_;
  const Tree tree_;
  Verdict verdict_;
  bool near_ = false;            // does the sphere come near the mesh at all?
  double from_ = 0, width_ = 1;  // the time when it does, and for how long
  Question question_;
  Walk walk_;
};

}  // namespace first_contact::bvh
