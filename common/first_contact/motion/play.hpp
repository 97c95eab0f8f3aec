#pragma once
#include <concepts>
#include <utility>
#include <vector>

#include "first_contact/motion/sweep_tween.hpp"
#include "first_contact/response/rebound.hpp"

/// \file
/// After the contact: the tween is played, and what it meets turns it aside. What it does then is the animator's
/// choice. Each contact maps all that is to come linearly, about the place where it happens; as curves go along with
/// such a map, a path that was bent is a path of the same kind, and can be swept again.

namespace first_contact {

/// What a tween does after a contact.
class After {
 public:
  /// It stays where it is.
  static After stop() { return {Kind::stop, Surface(0, 0)}; }
  /// It goes on along the surface with what of its way does not lead against it (paper, 2.2), less by friction: until
  /// its end, also where its path would lead away again.
  static After slide(double friction = 0) { return {Kind::bend, Surface(0, friction)}; }
  /// It is thrown back: the way that is left is mirrored, and made flatter by restitution and friction.
  static After bounce(double restitution, double friction = 0) {
    return {Kind::bend, Surface(restitution, friction)};
  }

  /// What becomes of a motion in that direction at a surface with that normal.
  Eigen::Matrix3d map(const Vector& motion, const Vector& normal) const;

 private:
  enum class Kind { stop, bend };
  After(Kind kind, const Surface& surface) : kind_(kind), surface_(surface) {}

  Kind kind_;
  Surface surface_;
};

/// A tween as it goes past obstacles.
class Played {
 public:
  /// As if there were nothing in its way.
  explicit Played(Tween tween) : tween_(std::move(tween)) {}

  /// Where it is at that time.
  Point at(double time) const;
  /// The contacts, in the order of time, on the tween's clock.
  const std::vector<Contact>& contacts() const { return contacts_; }
  /// As it was before.
  const Tween& tween() const { return tween_; }
  /// How its places are bent after its last contact.
  Bend bend() const { return bends_.empty() ? Bend() : bends_.back(); }
  /// Bends what is to come after a contact, which is not before any other.
  /// \param here  where the centre is then
  void turn_aside(const Contact& contact, const Point& here, const After& after);

 private:
  Tween tween_;
  std::vector<Contact> contacts_;
  std::vector<Bend> bends_;    // one after each contact,
  std::vector<Point> places_;  // ... where the centre is then
};

/// Plays a tween of a sphere past obstacles: sweeps it to its first contact, maps what is left, and sweeps that, until
/// nothing is met. Between contacts it is swept as any tween, with the same gap.
/// \param most_contacts  after so many it stays where it is
/// \throws std::invalid_argument as the sweep of a tween does.
Played play(const Tween& tween, double radius, const SphereSweep& first_contact_of, double largest_coordinate,
            const After& after, int most_contacts);

/// The same for whatever `sweep(moving, obstacle)` and `largest_coordinate(obstacle)` are written for.
template <Obstacle Any>
requires requires(const Any& obstacle) {
  { largest_coordinate(obstacle) } -> std::convertible_to<double>;
}
Played play(const Tween& tween, double radius, const Any& obstacle, const After& after,
            int most_contacts = 64) {
  return play(
      tween, radius, [&](const Moving<Sphere>& chord) { return sweep(chord, obstacle); },
      largest_coordinate(obstacle), after, most_contacts);
}

}  // namespace first_contact
