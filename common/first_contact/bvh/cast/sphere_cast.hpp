#pragma once
#include <array>
#include <optional>

#include "first_contact/bvh/cast/parts.hpp"
#include "first_contact/bvh/cast/verdict.hpp"

namespace first_contact::bvh {

/// One cast: a walk, which excludes, and a verdict, which decides.
///
/// The idea: what is to be decided can wait. Of each triangle that the walk leaves over it is enough to know
/// when the sphere comes to touch it, to a millionth; the walk may stop where one is touched for certain, and
/// only what is touched at the very end is worth the long tests of the verdict. They may show that this hope
/// was false, where the sphere leaves what it overlaps at the start, or slides along a seam: then nothing is
/// touched by the time that was hoped for, and the cast is done once more, each triangle decided in its turn.
/// So hope never changes the answer. It equals deciding at once.
/// Measured (./course bench --own --sides 707, with hope and without): .23 and .37 of the textbook for a long
/// cast, .25 and .36 for an aimed one.
class SphereCast {
 public:
  SphereCast(const Moving<Sphere>& moving, const Parts& parts, const Walker& walker);

  /// Goes on to the end.
  void run();
  std::optional<Contact> contact() const { return verdict_.contact(); }

  ///@{
  /// In turns: one small step, from the pause after which it is named. \returns the next
  Pause begin() { return near_ ? walker_.resume(walk_) : Pause::end; }
  Pause visit_node() { return walker_.visit_node(tree_, walk_); }
  Pause visit_leaf() { return walker_.visit_leaf(tree_, walk_); }
  Pause fetch_corners() const;
  Pause decide();
  ///@}
  /// Decides about what was postponed. \returns false if the walk has to begin once more
  bool finish();

 private:
  void decide_leaf();
  void decide_about(const LeafFace& face, int lane);
  void consider(const LeafFace& face, bool overlapping);
  void postpone_face(const LeafFace& face, double early, double late);
  /// A time of the walk as one of the cast.
  double time_of(float tau) const { return walk_.path.from_time + tau * walk_.path.duration; }
  void note_latest();
  void consider_postponed();

  const Parts& parts_;
  const Walker& walker_;
  const Tree& tree_;
  Verdict verdict_;
  bool near_;      // does the sphere come near the mesh at all?
  bool ordinary_;  // is nothing so large or so small that products leave the range of double?
  Question question_;

  /// A triangle of which some features are touched, perhaps.
  struct Postponed {
    LeafFace face;
    double early;  // the least of its times
    Found found;
  };
  std::array<Postponed, 24> postponed_;
  std::size_t postponed_count_ = 0;
  bool hopeful_ = true;
  double hoped_ = 2;  // by then something is touched, as far as can be seen
  Walk walk_;
};

/// The sweep with a given walker: tests compare them.
std::optional<Contact> sweep(const Moving<Sphere>& moving, const Parts& parts, const Walker& walker);

}  // namespace first_contact::bvh
