#pragma once
#include "task.hpp"
#include "workbook/sheet_of.hpp"

/// The judge adds up the angles under which the sides are seen: a full turn from inside, none from outside.
inline bool judge(const std::vector<Vector2>& polygon, Vector2 P) {
  double turned = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2 a = polygon[i] - P, b = polygon[(i + 1) % polygon.size()] - P;
    turned += std::atan2(cross(a, b), dot(a, b));
  }
  return std::llround(turned / (2 * std::acos(-1.0))) % 2 != 0;
}

inline Exercise<Signature> exercise() {
  const std::vector<Vector2> square{{0, 0}, {4, 0}, {4, 4}, {0, 4}},
      diamond{{0, -2}, {2, 0}, {0, 2}, {-2, 0}};
  const std::vector<Vector2> bay{{0, 0}, {6, 0}, {6, 6}, {3, 1}, {0, 6}},
      saw{{0, 0}, {8, 0}, {8, 4}, {6, 2}, {4, 4}, {2, 2}, {0, 4}};
  const std::vector<Vector2> way_back(square.rbegin(), square.rend());
  Exercise<Signature> probes;
  probes.asked = "true if P lies inside of the polygon";
  probes.names = {"polygon", "P"};
  probes.chosen = {
      {"in a square", {square, {1, 2}}},
      {"left of it: two sides are crossed", {square, {-1, 2}}},
      {"right of it", {square, {5, 2}}},
      {"above it", {square, {2, 5}}},
      {"in a square whose corners go round the other way", {way_back, {1, 2}}},
      {"in the centre of a diamond: the way leads through a corner", {diamond, {0, 0}}},
      {"left of the diamond, level with two corners", {diamond, {-3, 0}}},
      {"left of the diamond, level with its top: the way touches a corner", {diamond, {-3, 2}}},
      {"left of the diamond, level with its lowest corner", {diamond, {-3, -2}}},
      {"in the bay of a concave polygon: outside", {bay, {3, 4}}},
      {"in its left arm", {bay, {0.5, 3}}},
      {"left of a saw, level with its teeth", {saw, {-1, 2}}},
      {"in a tooth of the saw, level with the notches", {saw, {0.5, 2}}},
      {"level with a level side", {square, {-1, 0}}},
      {"near the side from the last corner to the first", {square, {0.25, 2}}},
  };
  probes.random = [](Chance& chance) {
    std::vector<Vector2> polygon;
    for (std::size_t n = 3 + chance.below(5); n > 0; --n) polygon.push_back(chance.vector2(4));
    return std::tuple{polygon, chance.vector2(3)};
  };
  probes.allowed = [](const auto& input) { return std::get<0>(input).size() >= 3; };
  probes.judge = judge;
  probes.along = {"x of P (0: outside, 1: inside)", -4, 8,
                  [](auto& input, double at) { std::get<1>(input).x = at; }};
  return probes;
}
