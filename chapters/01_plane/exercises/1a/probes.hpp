#pragma once
#include "task.hpp"
#include "workbook/sheet_of.hpp"

/// The judge makes N a unit vector first, and asks for the height of the ball's lowest point at both ends.
inline std::optional<double> judge(Plane E, Point S0, Vector V, double r) {
  const Plane unit{E.N / norm(E.N), E.D / norm(E.N)};
  const double begin = dot(unit, S0) - r, end = dot(unit, S0 + V) - r;
  if (end > 0) return {};
  return begin / (begin - end);
}

inline Exercise<Signature> exercise() {
  const Plane floor{{0, 0, 1}, 0};
  Exercise<Signature> probes;
  probes.asked = "the t in [0, 1] at which the ball first touches the plane, or nothing";
  probes.names = {"E", "S0", "V", "r"};
  probes.chosen = {
      {"a ball that falls on a floor", {floor, {0, 0, 2}, {0, 0, -2}, 0.5}},
      {"the scene of the chapter", {floor, {-0.9, 0, 2.1}, {1.65, 0, -1.6}, 0.7}},
      {"a normal of length 2", {{{0, 0, 2}, 0}, {0, 0, 2}, {0, 0, -2}, 0.5}},
      {"a normal of length 1/2", {{{0, 0, 0.5}, 0}, {0, 0, 2}, {0, 0, -2}, 0.5}},
      {"a floor that is elsewhere, at height 3", {{{0, 0, 1}, -3}, {0, 0, 5}, {0, 0, -2}, 0.5}},
      {"a point: r is 0", {floor, {0, 0, 1}, {0, 0, -2}, 0}},
      {"a touch at the very end, t = 1", {floor, {0, 0, 2}, {0, 0, -1.5}, 0.5}},
      {"a motion that ends too early", {floor, {0, 0, 2}, {0, 0, -1}, 0.5}},
      {"a ball that leaves", {floor, {0, 0, 2}, {0, 0, 2}, 0.5}},
      {"a motion along the plane", {floor, {0, 0, 2}, {3, 0, 0}, 0.5}},
      {"no motion at all", {floor, {0, 0, 2}, {0, 0, 0}, 0.5}},
      {"a slanted plane", {{{3, 0, 4}, -5}, {3, 0, 4}, {-4, 1, -3}, 0.5}},
  };
  probes.random = [](Chance& chance) {
    return std::tuple{Plane{chance.vector(4), chance.number(-4, 4)}, chance.vector(8), chance.vector(12),
                      chance.number(0, 2)};
  };
  probes.allowed = [](const auto& input) {
    const auto& [E, S0, V, r] = input;
    return norm(E.N) > 0.1 && r >= 0 && dot(E, S0) > 1.001 * r * norm(E.N);
  };
  probes.judge = judge;
  probes.along = {"length of N", 0.25, 4, [](auto& input, double length) {
                    auto& E = std::get<0>(input);
                    const double scale = length / norm(E.N);
                    E = {scale * E.N, scale * E.D};
                  }};
  return probes;
}
