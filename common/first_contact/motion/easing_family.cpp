#include "first_contact/motion/easing_family.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "first_contact/geometry/refuse.hpp"
#include "first_contact/motion/easing_formula.hpp"

namespace first_contact::ease {

namespace {

void require(bool fine, const char* what, double value, const char* rule) {
  if (!fine || !std::isfinite(value)) refuse(what, value, rule);
}

}  // namespace

Easing out(const Easing& in) {
  std::vector<double> turns = in.turns();
  std::reverse(turns.begin(), turns.end());
  for (double& turn : turns) turn = 1 - turn;
  return {[in](double t) { return 1 - in(1 - t); }, std::move(turns)};
}

Easing in_out(const Easing& in) {
  std::vector<double> turns;
  for (const double turn : in.turns()) turns.push_back(turn / 2);
  for (std::size_t i = in.turns().size(); i-- > 0;) turns.push_back(1 - in.turns()[i] / 2);
  return {[in](double t) { return t < 0.5 ? in(2 * t) / 2 : 1 - in(2 - 2 * t) / 2; }, std::move(turns)};
}

Easing power(double exponent) {
  require(exponent > 0, "easing's exponent", exponent, "must be positive and finite");
  return {[exponent](double t) { return std::pow(t, exponent); }, {}};
}

Easing exponential(double b) {
  require(b != 0 && std::abs(b) <= 1000, "easing's exponent", b, "must not be 0, and at most 1000 in size");
  return {[b](double t) { return formula::exponential(t, b); }, {}};
}

Easing back(double overshoot) {
  require(overshoot >= 0, "easing's overshoot", overshoot, "must be finite and not negative");
  std::vector<double> turns;
  if (overshoot > 0) turns.push_back(2.0 / 3 * (overshoot / (overshoot + 1)));
  return {[overshoot](double t) { return formula::back(t, overshoot); }, std::move(turns)};
}

Easing elastic(double amplitude, double period) {
  require(amplitude >= 1, "easing's amplitude", amplitude, "must be finite and at least 1");
  require(period >= 1.0 / 64, "easing's period", period, "must be finite and at least 1/64");
  return [=](double t) { return formula::elastic(t, amplitude, period); };
}

Easing spring(double cycles, double damping) {
  require(cycles >= 0.001 && cycles <= 64, "spring's cycles", cycles, "must be from 0.001 to 64");
  require(damping >= 0.01 && damping <= 100, "spring's damping", damping, "must be from 0.01 to 100");
  const double end = formula::spring(1, cycles, damping);
  return [=](double t) { return formula::spring(t, cycles, damping) / end; };
}

}  // namespace first_contact::ease
