#pragma once
#include "task.hpp"
#include "workbook/sheet_of.hpp"

/// The judge walks along the path and looks for the centre's least distance from the plane.
inline bool judge(Plane E, double r, Point S0, Point S1) {
  const double begin = dot(E, S0), end = dot(E, S1);
  double least = std::min(std::abs(begin), std::abs(end));
  if ((begin < 0) != (end < 0)) least = 0;  // the plane itself lies between the two
  return least > r;
}

inline Exercise<Signature> exercise() {
  const Plane floor{{0, 0, 1}, 0};
  Exercise<Signature> probes;
  probes.asked = "true if the ball touches the plane at no time between S0 and S1";
  probes.names = {"E", "r", "S0", "S1"};
  probes.chosen = {
      {"above the floor at both ends", {floor, 0.5, {0, 0, 2}, {1, 0, 3}}},
      {"it ends in the floor", {floor, 0.5, {0, 0, 2}, {0, 0, 0.25}}},
      {"it begins in the floor", {floor, 0.5, {0, 0, 0.25}, {0, 0, 2}}},
      {"it passes through between two pictures", {floor, 0.5, {0, 0, 2}, {0, 0, -3}}},
      {"it passes through from below", {floor, 0.5, {0, 0, -2}, {0, 0, 3}}},
      {"it passes through, and the middle of its way is free", {floor, 0.5, {0, 0, 1}, {0, 0, -9}}},
      {"below the floor at both ends", {floor, 0.5, {0, 0, -2}, {1, 0, -3}}},
      {"free, and the floor is elsewhere", {{{0, 0, 1}, 5}, 0.5, {0, 0, -2}, {0, 0, -4}}},
      {"it ends on the other side and deep", {floor, 0.5, {0, 0, 2}, {0, 0, -0.25}}},
      {"both ends deep", {floor, 1, {0, 0, 0.5}, {0, 0, -0.5}}},
      {"a point that passes through", {floor, 0, {0, 0, 1}, {0, 0, -1}}},
  };
  probes.random = [](Chance& chance) {
    return std::tuple{Plane{chance.unit(), chance.number(-4, 4)}, chance.number(0, 3), chance.vector(6),
                      chance.vector(6)};
  };
  probes.allowed = [](const auto& input) {
    return std::abs(norm(std::get<0>(input).N) - 1) < 1e-6 && std::get<1>(input) >= 0;
  };
  probes.judge = judge;
  probes.along = {"D (0: false, 1: true)", -6, 6, [](auto& input, double at) { std::get<0>(input).D = at; }};
  return probes;
}
