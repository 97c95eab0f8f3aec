#pragma once
#include <concepts>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "first_contact/geometry/space.hpp"

/// \file
/// Easings: how far along its way a tween is, for the part of its time that has passed (paper, 1.1).
///
/// Each is exactly 0 at 0 and exactly 1 at 1, and stays at these values before and after, so that a tween
/// ends where it should. In between, `back` and `elastic` go beyond.

namespace first_contact {

/// From the part of the time, in [0, 1], to the part of the way: one of those below, or a function of one's own.
class Easing {
 public:
  /// Any function of a double. It is asked at 0, 1/512, 2/512, ... where it turns back: what it does to and fro
  /// between two of these is not known to a sweep.
  /// \throws std::invalid_argument if there is no function, or it gives a value that is not finite.
  template <class Function>
  requires(std::is_invocable_r_v<double, const Function&, double> && !std::same_as<Function, Easing>)
      Easing(Function function)
      : Easing(std::function<double(double)>(std::move(function))) {}
  /// The same.
  Easing(std::function<double(double)> function);
  /// A function of which it is known where it turns back: ascending, inside of (0, 1).
  Easing(std::function<double(double)> function, std::vector<double> turns);

  /// The part of the way at the part t of the time: 0 up to t = 0, 1 from t = 1 on.
  double operator()(double t) const { return !(t > 0) ? 0 : t >= 1 ? 1 : known_->function(t); }
  /// Where it turns back, ascending: between two of them, and the ends, it only rises, or only falls.
  const std::vector<double>& turns() const { return known_->turns; }

 private:
  struct Known {
    std::function<double(double)> function;
    std::vector<double> turns;
  };
  std::shared_ptr<const Known> known_;
};

namespace ease {

/// Constant speed.
double linear(double t);

///@{
/// Slow at first. Penner's families ("Programming Macromedia Flash MX", ch. 7).
double in_quadratic(double t);
double in_cubic(double t);
double in_quartic(double t);
double in_quintic(double t);
double in_sine(double t);
double in_exponential(double t);  ///< (2^10t - 1) / 1023: Penner's own starts at 0.001, not at 0
double in_circular(double t);
double in_back(double t);     ///< first 10 % the wrong way
double in_elastic(double t);  ///< a spring that swings up
double in_bounce(double t);   ///< a ball dropped on a floor with restitution 1/2, backwards
///@}

///@{
/// Slow at the end: the mirror image, out(t) = 1 - in(1 - t).
double out_quadratic(double t);
double out_cubic(double t);
double out_quartic(double t);
double out_quintic(double t);
double out_sine(double t);
double out_exponential(double t);
double out_circular(double t);
double out_back(double t);
double out_elastic(double t);
double out_bounce(double t);  ///< a ball dropped on a floor with restitution 1/2, held at its fourth impact
///@}

///@{
/// Slow at both ends: `in`, half as large, and then its mirror image.
double in_out_quadratic(double t);
double in_out_cubic(double t);
double in_out_quartic(double t);
double in_out_quintic(double t);
double in_out_sine(double t);
double in_out_exponential(double t);
double in_out_circular(double t);
double in_out_back(double t);
double in_out_elastic(double t);
double in_out_bounce(double t);
///@}

/// An easing with its name, and with the `in` of its family.
struct Named {
  std::string_view name;  ///< such as "in-out cubic"
  Easing easing;          ///< the function
  Easing in;              ///< the `in` of its family
};

/// All of them: linear, then for each family in, out, in-out.
std::span<const Named> all();

}  // namespace ease

/// One step toward a goal that may itself move: what remains of the way shrinks by e^(-rate dt), so that two
/// steps of dt/2 do what one step of dt does, at any frame rate. The tempting lerp(a, b, 0.1) once a frame
/// does not: after a second 4.2 % of the way is left at 30 frames per second, but 0.18 % at 60.
///
/// \param rate per unit of time; ln 2 / rate is the time in which the way left is halved
/// \throws std::invalid_argument if rate or dt is negative, or a number is not finite.
double damp(double from, double goal, double rate, double dt);
/// The same for a point.
Point damp(const Point& from, const Point& goal, double rate, double dt);

}  // namespace first_contact
