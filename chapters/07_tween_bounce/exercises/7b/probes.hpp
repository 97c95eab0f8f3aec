#pragma once
#include "task.hpp"
#include "workbook/sheet_of.hpp"

/// The judge weighs the control points with Bernstein's polynomials.
inline Vector2 judge(const std::vector<Vector2>& points, double t) {
  const auto n = static_cast<double>(points.size()) - 1;
  Vector2 sum;
  double choose = 1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto k = static_cast<double>(i);
    sum = sum + choose * std::pow(t, k) * std::pow(1 - t, n - k) * points[i];
    choose *= (n - k) / (k + 1);
  }
  return sum;
}

inline Exercise<Signature> exercise() {
  using Points = std::vector<Vector2>;
  const Points arch{{0, 0}, {1, 3}, {4, 3}, {6, 0}};
  Exercise<Signature> probes;
  probes.asked = "the point at t of the Bézier curve with these control points";
  probes.names = {"points", "t"};
  probes.chosen = {
      {"a straight line, a quarter of the way", {Points{{0, 0}, {4, 8}}, 0.25}},
      {"three points, at one half", {Points{{0, 0}, {2, 4}, {4, 0}}, 0.5}},
      {"an arch of four points, at a quarter", {arch, 0.25}},
      {"its beginning: the first point", {arch, 0}},
      {"its end: the last point", {arch, 1}},
      {"five points", {Points{{0, 0}, {1, 2}, {2, -2}, {3, 2}, {4, 0}}, 0.75}},
      {"one point alone", {Points{{3, 5}}, 0.25}},
      {"control points at one place", {Points{{1, 1}, {1, 1}, {4, 4}}, 0.5}},
      {"seven points", {Points{{0, 1}, {1, 0}, {2, 3}, {3, 1}, {4, 4}, {5, 0}, {6, 2}}, 0.375}},
  };
  probes.random = [](Chance& chance) {
    Points points;
    for (std::size_t n = 1 + chance.below(6); n > 0; --n) points.push_back(chance.vector2(5));
    return std::tuple{points, chance.number(0, 1)};
  };
  probes.allowed = [](const auto& input) {
    const auto& [points, t] = input;
    return !points.empty() && t >= 1e-6 && t <= 1 - 1e-6;
  };
  probes.judge = judge;
  probes.unit = Unit::scene;
  probes.along = {"t (x of the point)", 0, 1, [](auto& input, double at) { std::get<1>(input) = at; }};
  return probes;
}
