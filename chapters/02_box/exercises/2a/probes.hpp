#pragma once
#include "task.hpp"
#include "workbook/sheet_of.hpp"

/// The judge looks at all eight vertices.
inline double judge(const Box& box, Vector N) {
  double most = 0;
  for (const double a : {-0.5, 0.5})
    for (const double b : {-0.5, 0.5})
      for (const double c : {-0.5, 0.5}) most = std::max(most, dot(a * box.R + b * box.S + c * box.T, N));
  return most;
}

/// A box whose axes have these lengths, turned by quarter turns and by angles with a 3-4-5 triangle.
inline Box turned_box(Chance& chance, double most) {
  const double a = chance.number(0, most), b = chance.number(0, most), c = chance.number(0, most);
  switch (chance.below(4)) {
    case 0:
      return {chance.vector(3), {a, 0, 0}, {0, b, 0}, {0, 0, c}};
    case 1:
      return {chance.vector(3), {0.6 * a, 0.8 * a, 0}, {-0.8 * b, 0.6 * b, 0}, {0, 0, -c}};
    case 2:
      return {chance.vector(3), {0, 0.6 * a, -0.8 * a}, {0, 0.8 * b, 0.6 * b}, {c, 0, 0}};
    default:
      break;
  }
  return {chance.vector(3), a / 3 * Vector{1, 2, 2}, b / 3 * Vector{2, 1, -2}, c / 3 * Vector{2, -2, 1}};
}

inline Exercise<Signature> exercise() {
  const Vector up{0, 0, 1};
  Exercise<Signature> probes;
  probes.asked = "how far the box reaches from its centre along N";
  probes.names = {"box", "N"};
  probes.chosen = {
      {"a cube that stands upright", {{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}}, up}},
      {"a brick that stands upright", {{{0, 0, 5}, {4, 0, 0}, {0, 2, 0}, {0, 0, 1}}, up}},
      {"all axes slanted, and upward", {{{0, 0, 0}, {1, 2, 2}, {-2, -1, 2}, {2, -2, 1}}, up}},
      {"an axis that points down", {{{0, 0, 0}, {1, 2, 2}, {2, 1, -2}, {2, -2, 1}}, up}},
      {"all axes downward", {{{0, 0, 0}, {-1, -2, -2}, {2, 1, -2}, {-2, 2, -1}}, up}},
      {"a normal that points down", {{{0, 0, 0}, {1, 2, 2}, {-2, -1, 2}, {2, -2, 1}}, -up}},
      {"a slanted normal", {{{1, 1, 1}, {4, 0, 0}, {0, 2, 0}, {0, 0, 6}}, {0.6, 0, 0.8}}},
      {"a plate: one axis has length 0", {{{0, 0, 0}, {2, 4, 4}, {-4, -2, 4}, {0, 0, 0}}, up}},
  };
  probes.random = [](Chance& chance) { return std::tuple{turned_box(chance, 6), chance.unit()}; };
  probes.allowed = [](const auto& input) {
    const auto& [box, N] = input;
    return std::abs(norm(N) - 1) < 1e-6 &&
           std::abs(dot(box.R, box.S)) + std::abs(dot(box.S, box.T)) + std::abs(dot(box.T, box.R)) < 1e-4;
  };
  probes.judge = judge;
  probes.unit = Unit::scene;
  probes.along = {"size of R", 0, 4,
                  [](auto& input, double at) { std::get<0>(input).R = at * std::get<0>(input).R; }};
  return probes;
}
