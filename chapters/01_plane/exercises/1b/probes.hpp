#pragma once
#include "task.hpp"
#include "workbook/sheet_of.hpp"

/// The judge turns the plane so that the ball is in front, and asks how the height of the centre goes from
/// begin to end.
inline std::optional<double> judge(Plane E, Point S0, Vector V, double r) {
  const double side = dot(E, S0) < 0 ? -1 : 1;
  const double begin = side * dot(E, S0), end = side * dot(E, S0 + V);
  if (end >= begin) return {};
  if (begin <= r) return 0;
  if (end > r) return {};
  return (begin - r) / (begin - end);
}

inline Exercise<Signature> exercise() {
  const Plane floor{{0, 0, 1}, 0};
  Exercise<Signature> probes;
  probes.asked =
      "the first contact in [0, 1], from either side; 0 if it overlaps and goes deeper; else nothing";
  probes.names = {"E", "S0", "V", "r"};
  probes.chosen = {
      {"a ball that falls on a floor", {floor, {0, 0, 2}, {0, 0, -2}, 0.5}},
      {"a ball that rises to a ceiling: it is behind the plane", {floor, {0, 0, -2}, {0, 0, 2}, 0.5}},
      {"behind a plane that is elsewhere", {{{0, 0, 1}, -4}, {0, 0, 1}, {0, 0, 4}, 1}},
      {"an overlap that goes deeper", {floor, {0, 0, 0.25}, {0, 0, -0.125}, 0.5}},
      {"an overlap that leaves", {floor, {0, 0, 0.25}, {0, 0, 2}, 0.5}},
      {"an overlap from behind that goes deeper", {floor, {0, 0, -0.25}, {0, 0, 0.125}, 0.5}},
      {"an overlap from behind that leaves", {floor, {0, 0, -0.25}, {0, 0, -2}, 0.5}},
      {"an overlap that moves along the plane", {floor, {0, 0, 0.25}, {3, 0, 0}, 0.5}},
      {"a touch at the start that goes deeper", {floor, {0, 0, 0.5}, {0, 0, -1}, 0.5}},
      {"a touch at the start that leaves", {floor, {0, 0, 0.5}, {0, 0, 1}, 0.5}},
      {"an overlap that goes through to the other side", {floor, {0, 0, 0.25}, {0, 0, -4}, 0.5}},
      {"a ball that leaves", {floor, {0, 0, 2}, {0, 0, 1}, 0.5}},
      {"a motion that ends too early", {floor, {0, 0, 2}, {0, 0, -1}, 0.5}},
      {"from behind, a motion that ends too early", {floor, {0, 0, -2}, {0, 0, 1}, 0.5}},
      {"no motion, apart", {floor, {0, 0, 2}, {0, 0, 0}, 0.5}},
  };
  probes.random = [](Chance& chance) {
    return std::tuple{Plane{chance.unit(), chance.number(-4, 4)}, chance.vector(5), chance.vector(8),
                      chance.number(0, 3)};
  };
  probes.allowed = [](const auto& input) {
    const auto& [E, S0, V, r] = input;
    return std::abs(norm(E.N) - 1) < 1e-6 && r >= 0 && std::abs(dot(E, S0)) > 1e-3;
  };
  probes.judge = judge;
  probes.along = {"D", -4, 4, [](auto& input, double at) { std::get<0>(input).D = at; }};
  return probes;
}
