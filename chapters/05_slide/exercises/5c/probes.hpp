#pragma once
#include "task.hpp"
#include "workbook/sheet_of.hpp"

/// The judge halves: the longest way at whose end, and nowhere before, the gap is too small.
inline double judge(Plane E, Point S0, Vector V, double r, double gap) {
  const auto height = [&](double t) { return dot(E, S0 + t * V) - r - gap; };
  if (height(1) >= std::min(0.0, height(0))) return 1;
  if (height(0) <= 0) return 0;
  double free = 0, blocked = 1;
  for (int i = 0; i < 200; ++i) (height((free + blocked) / 2) >= 0 ? free : blocked) = (free + blocked) / 2;
  return free;
}

inline Exercise<Signature> exercise() {
  const Plane floor{{0, 0, 1}, 0};
  Exercise<Signature> probes;
  probes.asked = "how much of the motion the ball may make and still keep the gap from the wall";
  probes.names = {"E", "S0", "V", "r", "gap"};
  probes.chosen = {
      {"straight down", {floor, {0, 0, 3}, {0, 0, -4}, 1, 0.25}},
      {"slantwise, 3 to 4", {floor, {0, 0, 3}, {3, 0, -4}, 1, 0.25}},
      {"at one degree or so, where a gap along the path is nothing",
       {floor, {0, 0, 1.5}, {57, 0, -1}, 1, 0.25}},
      {"all the way: the motion ends before", {floor, {0, 0, 3}, {3, 0, -1}, 1, 0.25}},
      {"it ends within the gap, and not in the wall", {floor, {0, 0, 3}, {0, 0, -1.875}, 1, 0.25}},
      {"away from the wall", {floor, {0, 0, 3}, {3, 0, 4}, 1, 0.25}},
      {"along the wall", {floor, {0, 0, 3}, {3, 0, 0}, 1, 0.25}},
      {"already within the gap, toward the wall", {floor, {0, 0, 1.125}, {3, 0, -4}, 1, 0.25}},
      {"already within the gap, away", {floor, {0, 0, 1.125}, {3, 0, 4}, 1, 0.25}},
      {"already within the gap, along the wall", {floor, {0, 0, 1.125}, {3, 0, 0}, 1, 0.25}},
      {"no gap", {floor, {0, 0, 3}, {0, 0, -4}, 1, 0}},
      {"a slanted wall that is elsewhere", {{{0.6, 0, 0.8}, -2}, {3, 0, 6}, {-4, 1, -8}, 1, 0.5}},
  };
  probes.random = [](Chance& chance) {
    return std::tuple{Plane{chance.unit(), chance.number(-4, 4)}, chance.vector(6), chance.vector(9),
                      chance.number(0, 2), chance.number(0.125, 1)};
  };
  probes.allowed = [](const auto& input) {
    const auto& [E, S0, V, r, gap] = input;
    return std::abs(norm(E.N) - 1) < 1e-6 && r >= 0 && gap >= 0 && dot(E, S0) > r + 0.01;
  };
  probes.judge = judge;
  probes.along = {"x of V", -12, 12, [](auto& input, double at) { std::get<2>(input).x = at; }};
  return probes;
}
