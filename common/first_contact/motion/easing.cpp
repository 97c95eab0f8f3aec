#include "first_contact/motion/easing.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "first_contact/geometry/refuse.hpp"
#include "first_contact/motion/easing_formula.hpp"

namespace first_contact {

namespace {

// Where it is highest (sign 1) or lowest (-1) between two parts of the time, by thirds. It is flat there: half of
// the digits of t are enough for all digits of the value.
double extremum(const std::function<double(double)>& function, double low, double high, int sign) {
  for (int step = 0; step < 60; ++step) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    const bool nearer_to_b = sign * (function(a) - function(b)) < 0;
    (nearer_to_b ? low : high) = nearer_to_b ? a : b;
  }
  return (low + high) / 2;
}

std::vector<double> turns_of(const std::function<double(double)>& function) {
  constexpr int samples = 512;
  std::vector<double> turns;
  double before = 0, rising_since = 0;
  int way = 0;
  for (int i = 1; i <= samples; ++i) {
    const double t = i / double(samples), value = i < samples ? function(t) : 1;
    if (!std::isfinite(value)) refuse("easing's value", value, "must be finite");
    const int now = (value > before) - (value < before);
    if (now * way < 0) turns.push_back(extremum(function, rising_since, t, way));
    if (now != 0) way = now, rising_since = (i - 1) / double(samples);
    before = value;
  }
  return turns;
}

}  // namespace

Easing::Easing(std::function<double(double)> function, std::vector<double> turns)
    : known_(std::make_shared<const Known>(Known{std::move(function), std::move(turns)})) {
  if (!known_->function) refuse("easing", "must be a function");
}

Easing::Easing(std::function<double(double)> function)
    : Easing(function, function ? turns_of(function) : std::vector<double>()) {}

namespace ease {

namespace {

constexpr double pi = std::numbers::pi;

// The formulas, for t inside (0, 1).
double straight(double t) { return t; }
double quadratic(double t) { return t * t; }
double cubic(double t) { return t * t * t; }
double quartic(double t) { return t * t * t * t; }
double quintic(double t) { return t * t * t * t * t; }
double sine(double t) {
  const double half = std::sin(pi / 4 * t);
  return 2 * half * half;  // 1 - cos(pi t / 2), without its cancellation near 0
}
double exponential(double t) { return formula::exponential(t); }
double circular(double t) { return t * t / (1 + std::sqrt((1 - t) * (1 + t))); }  // 1 - sqrt(1 - t^2)
double back(double t) { return formula::back(t); }
double elastic(double t) { return formula::elastic(t); }

//! [bounce_easing]
// A ball dropped with g = 2 from height 1 lands at time 1 with speed 2; with restitution 1/2 it lands again
// at 2, at 2.5 and at 2.75. Between two impacts it is at (s - left)(right - s) above the floor.
double dropped(double t) {
  const double s = 2.75 * t;
  const double height = s < 1     ? (1 - s) * (1 + s)
                        : s < 2   ? (s - 1) * (2 - s)
                        : s < 2.5 ? (s - 2) * (2.5 - s)
                                  : (s - 2.5) * (2.75 - s);
  return 1 - height;
}
//! [bounce_easing]
double bounce(double t) { return 1 - dropped(1 - t); }

//! [easing_ends]
// An easing ends exactly at 1, whatever the formula's rounding: a tween that stops at 0.9999999 is a jump.
template <double (*Formula)(double)>
double in(double t) {
  return !(t > 0) ? 0 : t >= 1 ? 1 : Formula(t);
}
//! [easing_ends]

//! [easing_mirrors]
template <double (*Formula)(double)>
double out(double t) {
  return 1 - in<Formula>(1 - t);
}

template <double (*Formula)(double)>
double in_out(double t) {
  return t < 0.5 ? in<Formula>(2 * t) / 2 : 1 - in<Formula>(2 - 2 * t) / 2;
}
//! [easing_mirrors]

}  // namespace

double linear(double t) { return in<straight>(t); }

double in_quadratic(double t) { return in<quadratic>(t); }
double in_cubic(double t) { return in<cubic>(t); }
double in_quartic(double t) { return in<quartic>(t); }
double in_quintic(double t) { return in<quintic>(t); }
double in_sine(double t) { return in<sine>(t); }
double in_exponential(double t) { return in<exponential>(t); }
double in_circular(double t) { return in<circular>(t); }
double in_back(double t) { return in<back>(t); }
double in_elastic(double t) { return in<elastic>(t); }
double in_bounce(double t) { return in<bounce>(t); }

double out_quadratic(double t) { return out<quadratic>(t); }
double out_cubic(double t) { return out<cubic>(t); }
double out_quartic(double t) { return out<quartic>(t); }
double out_quintic(double t) { return out<quintic>(t); }
double out_sine(double t) { return out<sine>(t); }
double out_exponential(double t) { return out<exponential>(t); }
double out_circular(double t) { return out<circular>(t); }
double out_back(double t) { return out<back>(t); }
double out_elastic(double t) { return out<elastic>(t); }
double out_bounce(double t) { return out<bounce>(t); }

double in_out_quadratic(double t) { return in_out<quadratic>(t); }
double in_out_cubic(double t) { return in_out<cubic>(t); }
double in_out_quartic(double t) { return in_out<quartic>(t); }
double in_out_quintic(double t) { return in_out<quintic>(t); }
double in_out_sine(double t) { return in_out<sine>(t); }
double in_out_exponential(double t) { return in_out<exponential>(t); }
double in_out_circular(double t) { return in_out<circular>(t); }
double in_out_back(double t) { return in_out<back>(t); }
double in_out_elastic(double t) { return in_out<elastic>(t); }
double in_out_bounce(double t) { return in_out<bounce>(t); }

std::span<const Named> all() {
  static const std::array<Named, 31> list{{{"linear", linear, linear},
                                           {"in quadratic", in_quadratic, in_quadratic},
                                           {"out quadratic", out_quadratic, in_quadratic},
                                           {"in-out quadratic", in_out_quadratic, in_quadratic},
                                           {"in cubic", in_cubic, in_cubic},
                                           {"out cubic", out_cubic, in_cubic},
                                           {"in-out cubic", in_out_cubic, in_cubic},
                                           {"in quartic", in_quartic, in_quartic},
                                           {"out quartic", out_quartic, in_quartic},
                                           {"in-out quartic", in_out_quartic, in_quartic},
                                           {"in quintic", in_quintic, in_quintic},
                                           {"out quintic", out_quintic, in_quintic},
                                           {"in-out quintic", in_out_quintic, in_quintic},
                                           {"in sine", in_sine, in_sine},
                                           {"out sine", out_sine, in_sine},
                                           {"in-out sine", in_out_sine, in_sine},
                                           {"in exponential", in_exponential, in_exponential},
                                           {"out exponential", out_exponential, in_exponential},
                                           {"in-out exponential", in_out_exponential, in_exponential},
                                           {"in circular", in_circular, in_circular},
                                           {"out circular", out_circular, in_circular},
                                           {"in-out circular", in_out_circular, in_circular},
                                           {"in back", in_back, in_back},
                                           {"out back", out_back, in_back},
                                           {"in-out back", in_out_back, in_back},
                                           {"in elastic", in_elastic, in_elastic},
                                           {"out elastic", out_elastic, in_elastic},
                                           {"in-out elastic", in_out_elastic, in_elastic},
                                           {"in bounce", in_bounce, in_bounce},
                                           {"out bounce", out_bounce, in_bounce},
                                           {"in-out bounce", in_out_bounce, in_bounce}}};
  return list;
}

}  // namespace ease

//! [damp]
double damp(double from, double goal, double rate, double dt) {
  require_length(rate, "damping rate");
  require_length(dt, "time step");
  for (const double value : {from, goal})
    if (!std::isfinite(value)) refuse("damped value", value, "must be finite");
  return lerp(from, goal, -std::expm1(-rate * dt));  // the part done: 1 - e^(-rate dt)
}
//! [damp]

Point damp(const Point& from, const Point& goal, double rate, double dt) {
  return {damp(from.x(), goal.x(), rate, dt), damp(from.y(), goal.y(), rate, dt),
          damp(from.z(), goal.z(), rate, dt)};
}

}  // namespace first_contact
