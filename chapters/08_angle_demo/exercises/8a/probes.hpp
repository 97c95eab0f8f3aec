#pragma once
#include "task.hpp"
#include "workbook/sheet_of.hpp"

/// The judge looks from the centre of mass, where both simply turn back along the normal.
inline Velocities judge(const Body& first, const Body& second, Vector2 N, double e) {
  const Vector2 n = N / norm(N), common = (first.mass * first.velocity + second.mass * second.velocity) /
                                          (first.mass + second.mass);
  const double one = dot(first.velocity - common, n), other = dot(second.velocity - common, n);
  if (dot(first.velocity - second.velocity, n) >= 0) return {first.velocity, second.velocity};
  return {first.velocity - (1 + e) * one * n, second.velocity - (1 + e) * other * n};
}

inline Exercise<Signature> exercise() {
  Exercise<Signature> probes;
  probes.asked = "the velocities of both bodies after the impact";
  probes.names = {"first", "second", "N", "e"};
  probes.chosen = {
      {"equal masses head on, steel: they exchange", {{1, {1, 0}}, {1, {-1, 0}}, {-1, 0}, 1}},
      {"one rests, equal masses, slantwise", {{1, {3, 1}}, {1, {0, 0}}, {-1, 0}, 1}},
      {"clay: they go on together along the normal", {{1, {3, 1}}, {1, {0, 0}}, {-1, 0}, 0}},
      {"half of the speed is given back", {{1, {3, 1}}, {1, {-1, 2}}, {-1, 0}, 0.5}},
      {"a heavy one against a light one", {{5, {1, 0}}, {1, {-1, 0}}, {-1, 0}, 1}},
      {"a light one against a heavy one", {{1, {1, 0}}, {5, {-1, 0}}, {-1, 0}, 1}},
      {"a slanted normal", {{2, {1, 0}}, {1, {-1, 0.5}}, {-0.6, -0.8}, 1}},
      {"a normal of length 5", {{2, {1, 0}}, {1, {-1, 0.5}}, {-3, -4}, 1}},
      {"they part: nothing happens", {{1, {-1, 0}}, {1, {1, 0}}, {-1, 0}, 1}},
      {"they move alike: nothing happens", {{1, {2, 1}}, {3, {2, 1}}, {-1, 0}, 1}},
      {"both fly the same way, and the first is faster", {{2, {4, 1}}, {1, {1, -1}}, {-1, 0}, 0.75}},
  };
  probes.random = [](Chance& chance) {
    return std::tuple{Body{chance.number(0.5, 6), chance.vector2(5)},
                      Body{chance.number(0.5, 6), chance.vector2(5)}, chance.vector2(3), chance.number(0, 1)};
  };
  probes.allowed = [](const auto& input) {
    const auto& [first, second, N, e] = input;
    return first.mass > 0.1 && second.mass > 0.1 && norm(N) > 0.1 && e >= -1e-6 && e <= 1 + 1e-6;
  };
  probes.judge = judge;
  probes.unit = Unit::scene;
  probes.along = {"x of the first velocity (x of the first afterwards)", -4, 4,
                  [](auto& input, double at) { std::get<0>(input).velocity.x = at; }};
  return probes;
}
