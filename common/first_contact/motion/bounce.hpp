#pragma once
#include <cstddef>
#include <optional>
#include <vector>

namespace first_contact {

/// The ball meets the floor, at height 0.
struct Landing {
  /// Since the start.
  double time;
  double speed;  ///< downwards, just before
};

/// The top of an arc.
struct Apex {
  /// Since the start.
  double time;
  /// Above the floor.
  double height;
};

/// A ball that falls on a floor and bounces, solved from impact to impact instead of in time steps. Between
/// two impacts it flies a parabola that is known exactly, so there is nothing to drift, and no impact is
/// late.
///
/// Its height is that of what touches the floor: of a ball's centre above the floor moved out by its radius
/// (paper, 1.2). Speeds are positive downwards, as in the paper's programs 1 to 3: v0 = 50 is thrown down, v0
/// = -50 up. Without gravity (g = 0) it flies straight: it meets the floor once if thrown down, and then
/// leaves for ever.
///
/// Error of times and speeds: at most 8 eps, relative.
///
/// Range: height, speed and gravity are at most 2^1000 = 1.07e301 in size, the height that it reaches 2^1001, and the
/// first impact and the rest come at a time that is a double.
class Bounce {
 public:
  /// \param height       at time 0, not negative
  /// \param speed_down   at time 0, any sign
  /// \param gravity      not negative
  /// \param restitution  e in [0, 1]: the part of the speed that an impact leaves
  /// \throws std::invalid_argument that names the value and the rule.
  Bounce(double height, double speed_down, double gravity, double restitution);

  /// Impact number n = 1, 2, ... in closed form; nothing if there is none, or at no time that is a double. With 0
  /// < e < 1 there are infinitely many, each e times as fast as the one before, and all before rest_time().
  std::optional<Landing> impact(std::size_t n) const;
  /// The top of the arc that follows impact n; with n = 0, of the first flight if it is thrown upwards.
  std::optional<Apex> apex(std::size_t n) const;

  /// The impacts up to a time: not more than `most`, and, as infinitely many may come before rest_time(),
  /// only as long as their times differ as doubles.
  std::vector<Landing> impacts(double until, std::size_t most) const;
  /// The tops of the arcs, under the same limits.
  std::vector<Apex> apexes(double until, std::size_t most) const;

  /// From when on the ball lies on the floor: the impacts' times have a limit (Zeno), t1 + (2 v1 / g) e / (1
  /// - e). Nothing if it never comes to rest there: e = 1, or no gravity to bring it back.
  std::optional<double> rest_time() const;

  /// Height at a time; a negative time counts as 0. So late that times no longer tell the flights apart, it is on
  /// the floor; without gravity, so high that no double tells, it is infinitely high.
  /// \throws std::invalid_argument if the time is not finite.
  double height(double time) const;
  /// Speed downwards at a time; at an impact, that after it.
  /// \throws std::invalid_argument if the time is not finite.
  double speed_down(double time) const;

 private:
  /// One flight, from an impact (or time 0) to the next: a parabola.
  struct Arc {
    double height;    // at its beginning
    double speed_up;  // at its beginning
    double since;     // the time that has passed since then
  };
  Arc arc(double time) const;
  double impact_time(std::size_t n) const;
  double impact_speed(std::size_t n) const;
  std::size_t impacts_until(double time) const;
  double first_rebound() const;

  double height_, speed_down_, gravity_, restitution_;
  std::optional<Landing> first_;
};

}  // namespace first_contact
