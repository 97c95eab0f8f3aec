#pragma once
#include "task.hpp"
#include "workbook/sheet_of.hpp"

/// The judge turns the room until N is z, and sets z to 0.
inline Vector judge(Vector w, Vector N) {
  const Vector z = N / norm(N);
  const Vector helper = std::abs(z.x) < 0.5 ? Vector{1, 0, 0} : Vector{0, 1, 0};
  const Vector x = cross(helper, z) / norm(cross(helper, z)), y = cross(z, x);
  return dot(w, x) * x + dot(w, y) * y + std::max(0.0, dot(w, z)) * z;
}

inline Exercise<Signature> exercise() {
  const Vector up{0, 0, 1};
  Exercise<Signature> probes;
  probes.asked = "what is left of w along the wall; w itself if it does not lead into the wall";
  probes.names = {"w", "N"};
  probes.chosen = {
      {"slantwise into a floor", {{3, 0, -4}, up}},
      {"straight into the floor: nothing is left", {{0, 0, -2}, up}},
      {"along the floor", {{3, 1, 0}, up}},
      {"away from the floor", {{3, 0, 4}, up}},
      {"straight away", {{0, 0, 4}, up}},
      {"a normal of length 2", {{3, 0, -4}, {0, 0, 2}}},
      {"a normal of length 1/2", {{3, 0, -4}, {0, 0, 0.5}}},
      {"a slanted wall", {{1, 0, -2}, {3, 0, 4}}},
      {"a slanted wall, away", {{1, 0, 2}, {3, 0, 4}}},
      {"no motion", {{0, 0, 0}, up}},
  };
  probes.random = [](Chance& chance) { return std::tuple{chance.vector(5), chance.vector(3)}; };
  probes.allowed = [](const auto& input) { return norm(std::get<1>(input)) > 0.05; };
  probes.judge = judge;
  probes.unit = Unit::scene;
  probes.along = {"length of N (x of the answer)", 0.25, 4, [](auto& input, double at) {
                    auto& N = std::get<1>(input);
                    N = at / norm(N) * N;
                  }};
  return probes;
}
