#pragma once
#include "task.hpp"
#include "workbook/sheet_of.hpp"

/// The judge goes to and fro between the walls (Dykstra's method): what each wall took last is given back
/// first.
inline Vector judge(Vector w, Vector N, Vector M) {
  Vector v = w, by_n, by_m;
  for (int i = 0; i < 4000; ++i) {
    const Vector a = v + by_n, b = a - std::min(0.0, dot(a, N)) * N;
    by_n = a - b;
    const Vector c = b + by_m, d = c - std::min(0.0, dot(c, M)) * M;
    by_m = c - d;
    v = d;
  }
  return v;
}

inline Exercise<Signature> exercise() {
  const Vector up{0, 0, 1}, left{-1, 0, 0}, lean{-0.6, 0, 0.8}, acute{-0.96, 0, -0.28};
  Exercise<Signature> probes;
  probes.asked = "the motion nearest to w that leads into neither of the two walls";
  probes.names = {"w", "N", "M"};
  probes.chosen = {
      {"into a right-angled crease: along it", {{2, 3, -1}, up, left}},
      {"away from both walls: as wished", {{-2, 3, 1}, up, left}},
      {"into the first wall alone: along that", {{-2, 3, -1}, up, left}},
      {"into the second wall alone", {{2, 3, 1}, up, left}},
      {"into a wide crease, into both walls: one wall would do", {{-1, 2, -3}, up, lean}},
      {"into a wide crease, between its walls: along it", {{1, 2, -3}, up, lean}},
      {"into a wide crease, mostly into the other wall", {{5, 2, -1}, up, lean}},
      {"into a sharp crease: one wall after the other does not do", {{2, 1, -0.25}, up, acute}},
      {"into a sharp crease, the other wall first", {{2, 1, -0.25}, acute, up}},
      {"straight into the crease: nothing is left", {{1, 0, -1}, up, left}},
      {"along the crease", {{0, 2, 0}, up, left}},
      {"along a floor, from a wall that leans over it", {{-3, 1, 0}, up, acute}},
      {"no motion", {{0, 0, 0}, up, left}},
  };
  probes.random = [](Chance& chance) { return std::tuple{chance.vector(4), chance.unit(), chance.unit()}; };
  probes.allowed = [](const auto& input) {
    const auto& [w, N, M] = input;
    return std::abs(norm(N) - 1) < 1e-6 && std::abs(norm(M) - 1) < 1e-6 && norm(cross(N, M)) > 0.25 &&
           dot(N, M) > -0.9;
  };
  probes.judge = judge;
  probes.tolerance = 1e-6;
  probes.unit = Unit::scene;
  probes.along = {"x of w (x of the answer)", -4, 4,
                  [](auto& input, double at) { std::get<0>(input).x = at; }};
  return probes;
}
