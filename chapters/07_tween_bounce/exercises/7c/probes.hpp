#pragma once
#include "task.hpp"
#include "workbook/sheet_of.hpp"

/// The judge inverts each of the three by a formula of its own.
inline std::optional<double> judge(double from, double to, double r, Easing easing) {
  if (to > r) return {};
  const double u = (from - r) / (from - to);
  if (easing == Easing::in) return std::cbrt(u);
  if (easing == Easing::out) return 1 - std::cbrt(1 - u);
  return 0.5 - std::sin(std::asin(1 - 2 * u) / 3);
}

inline Exercise<Signature> exercise() {
  Exercise<Signature> probes;
  probes.asked = "the time at which the ball first touches the floor, or nothing";
  probes.names = {"from", "to", "r", "easing (0: in, 1: out, 2: in_out)"};
  probes.chosen = {
      {"slow at the beginning", {5, -3, 1, Easing::in}},
      {"slow at the end", {5, -3, 1, Easing::out}},
      {"slow at both, and the contact is half way", {5, -3, 1, Easing::in_out}},
      {"slow at both, a quarter of the way", {5, -11, 1, Easing::in_out}},
      {"late: most of the way is made", {5, 0.5, 1, Easing::out}},
      {"early", {1.125, -9, 1, Easing::in}},
      {"it does not come so far", {5, 2, 1, Easing::in}},
      {"it rises", {5, 9, 1, Easing::out}},
      {"it stays", {5, 5, 1, Easing::in_out}},
      {"a point", {4, -4, 0, Easing::in}},
  };
  probes.random = [](Chance& chance) {
    const double r = chance.number(0, 2);
    return std::tuple{r + chance.number(0.25, 6), chance.number(-6, 4), r,
                      static_cast<Easing>(chance.below(3))};
  };
  probes.allowed = [](const auto& input) {
    const auto& [from, to, r, easing] = input;
    return r >= 0 && from > r + 0.01 && static_cast<int>(easing) >= 0 && static_cast<int>(easing) <= 2 &&
           (to > r || from - to > 0.05);
  };
  probes.judge = judge;
  probes.tolerance = 2e-9;
  probes.along = {"to", -8, 4, [](auto& input, double at) { std::get<1>(input) = at; }};
  return probes;
}
