#pragma once
#include "task.hpp"
#include "workbook/sheet_of.hpp"

/// The judge looks for a plane that has all eight vertices behind it.
inline bool judge(const std::array<Plane, 6>& frustum, const Box& box) {
  for (const Plane& E : frustum) {
    double highest = -std::numeric_limits<double>::infinity();
    for (const double a : {-0.5, 0.5})
      for (const double b : {-0.5, 0.5})
        for (const double c : {-0.5, 0.5})
          highest = std::max(highest, dot(E, box.Q + a * box.R + b * box.S + c * box.T));
    if (highest < 0) return true;
  }
  return false;
}

/// Looks along z from 1 to 9; its four sides lean out by 3 in 4.
inline const std::array<Plane, 6> camera{Plane{{0, 0, 1}, -1},    Plane{{0, 0, -1}, 9},
                                         Plane{{0.8, 0, 0.6}, 0}, Plane{{-0.8, 0, 0.6}, 0},
                                         Plane{{0, 0.8, 0.6}, 0}, Plane{{0, -0.8, 0.6}, 0}};

inline Exercise<Signature> exercise() {
  const auto cube = [](Point Q, double size) { return Box{Q, {size, 0, 0}, {0, size, 0}, {0, 0, size}}; };
  Exercise<Signature> probes;
  probes.asked = "true if the box lies wholly behind one of the six planes";
  probes.names = {"frustum", "box"};
  probes.chosen = {
      {"in the middle of what is seen", {camera, cube({0, 0, 5}, 1)}},
      {"behind the camera", {camera, cube({0, 0, -3}, 1)}},
      {"too far away", {camera, cube({0, 0, 12}, 1)}},
      {"far to the left", {camera, cube({-9, 0, 4}, 1)}},
      {"far to the right", {camera, cube({9, 0, 4}, 1)}},
      {"above", {camera, cube({0, 9, 4}, 1)}},
      {"across the near plane, its centre behind it: in view", {camera, cube({0, 0, 0.75}, 1)}},
      {"across a side, its centre inside", {camera, cube({-3, 0, 5}, 2)}},
      {"large, around the whole camera", {camera, cube({0, 0, 0}, 40)}},
      {"a long plank across the view, its centre outside",
       {camera, {{-9, 0, 5}, {16, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}}}},
      {"a plank whose axes point the other way",
       {camera, {{-9, 0, 5}, {-16, 0, 0}, {0, -0.5, 0}, {0, 0, -0.5}}}},
      {"a plank behind the camera, long but not toward it",
       {camera, {{0, 0, -1}, {20, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}}}},
      {"beside an edge: behind no single plane, so it is kept",
       {camera, {{-5.5, 5.5, 5}, {6, 6, 0}, {-0.25, 0.25, 0}, {0, 0, 0.25}}}},
  };
  probes.random = [](Chance& chance) {
    const double a = chance.number(0, 4), b = chance.number(0, 4), c = chance.number(0, 8);
    return std::tuple{camera, Box{chance.vector(10), a / 3 * Vector{1, 2, 2}, b / 3 * Vector{2, 1, -2},
                                  c / 3 * Vector{2, -2, 1}}};
  };
  probes.allowed = [](const auto& input) {
    const auto& [frustum, box] = input;
    return same(to_value(frustum), to_value(camera), {}) &&
           std::abs(dot(box.R, box.S)) + std::abs(dot(box.S, box.T)) + std::abs(dot(box.T, box.R)) < 1e-4;
  };
  probes.judge = judge;
  probes.along = {"x of the centre (0: kept, 1: rejected)", -12, 12,
                  [](auto& input, double at) { std::get<1>(input).Q.x = at; }};
  return probes;
}
