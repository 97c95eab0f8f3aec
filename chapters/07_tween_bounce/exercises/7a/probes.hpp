#pragma once
#include "task.hpp"
#include "workbook/sheet_of.hpp"

/// The judge writes the powers out.
inline Eased judge(double s, double p) {
  return {1 - std::pow(1 - s, p),
          s < 0.5 ? std::pow(2, p - 1) * std::pow(s, p) : 1 - std::pow(2, p - 1) * std::pow(1 - s, p)};
}

inline Exercise<Signature> exercise() {
  Exercise<Signature> probes;
  probes.asked = "(out, in_out), both made from in(s, p)";
  probes.names = {"s", "p"};
  probes.chosen = {
      {"a quarter of the time, squares", {0.25, 2}},
      {"three quarters of the time, squares", {0.75, 2}},
      {"the beginning", {0, 2}},
      {"the end", {1, 2}},
      {"one half", {0.5, 2}},
      {"just after one half", {0.53125, 2}},
      {"a quarter, cubes", {0.25, 3}},
      {"three quarters, cubes", {0.75, 3}},
      {"even motion", {0.25, 1}},
  };
  probes.random = [](Chance& chance) { return std::tuple{chance.number(0, 1), chance.number(1, 5)}; };
  probes.allowed = [](const auto& input) {
    const auto& [s, p] = input;
    return s >= 1e-6 && s <= 1 - 1e-6 && p >= 1;
  };
  probes.judge = judge;
  probes.along = {"s (in_out)", 0, 1, [](auto& input, double at) { std::get<0>(input) = at; }, 1};
  return probes;
}
