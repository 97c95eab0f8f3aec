#pragma once
#include "task.hpp"
#include "workbook/sheet_of.hpp"

/// The judge takes away all that goes along the edge, and solves in the plane that is left.
inline std::optional<double> judge(Point a, Point b, Point S0, Vector V, double r) {
  const Vector along = (b - a) / norm(b - a);
  const Vector m = S0 - a - dot(S0 - a, along) * along, v = V - dot(V, along) * along;
  const double vv = dot(v, v), mv = dot(m, v), under = vv * r * r - dot(cross(m, v), cross(m, v));
  if (mv >= 0 || vv == 0 || under < 0) return {};
  const double t = (-mv - std::sqrt(under)) / vv, foot = dot(S0 + t * V - a, along);
  if (t > 1 || foot < 0 || foot > norm(b - a)) return {};
  return t;
}

inline Exercise<Signature> exercise() {
  const Point a{0, 0, 0}, b{0, 2, 0};
  Exercise<Signature> probes;
  probes.asked =
      "the t in [0, 1] at which the ball first touches the line of the edge, if that is between a and b";
  probes.names = {"a", "b", "S0", "V", "r"};
  probes.chosen = {
      {"straight down on the middle of an edge", {a, b, {0, 1, 3}, {0, 0, -4}, 1}},
      {"beyond the end b", {a, b, {0, 2.5, 3}, {0, 0, -4}, 1}},
      {"beyond the end a", {a, b, {0, -0.5, 3}, {0, 0, -4}, 1}},
      {"aside of the edge", {a, b, {0.6, 1, 3}, {0, 0, -4}, 1}},
      {"it passes by", {a, b, {1.5, 1, 3}, {0, 0, -4}, 1}},
      {"it starts beside the edge's end and comes over it", {a, b, {0, -2, 3}, {0, 4, -4}, 1}},
      {"it starts beside the edge and has left it when it touches the line",
       {a, b, {0, 1, 3}, {0, 4, -4}, 1}},
      {"along the edge, never nearer", {a, b, {0, -3, 2}, {0, 6, 0}, 1}},
      {"a motion that ends too early", {a, b, {0, 1, 3}, {0, 0, -1}, 1}},
      {"it leaves", {a, b, {0, 1, 3}, {0, 0, 4}, 1}},
      {"a slanted edge", {{1, 1, 1}, {3, 3, 2}, {2, 1, 5}, {0, 1, -6}, 0.5}},
      {"the same edge, from b to a", {{3, 3, 2}, {1, 1, 1}, {2, 1, 5}, {0, 1, -6}, 0.5}},
      {"a long edge", {{0, -50, 0}, {0, 50, 0}, {0, 10, 3}, {1, 20, -4}, 1}},
  };
  probes.random = [](Chance& chance) {
    const Point a = chance.vector(3), b = chance.vector(3);
    Point S0 = chance.vector(4);
    const Vector V = chance.vector(8);
    const double r = chance.number(0.25, 2);
    if (chance.below(2) == 0)  // aimed: at some time the ball is near a point of the edge, or just beyond it
      S0 = a + chance.number(-0.25, 1.25) * (b - a) + chance.vector(0.5 * r) - chance.number(0, 1) * V;
    return std::tuple{a, b, S0, V, r};
  };
  probes.allowed = [](const auto& input) {
    const auto& [begin, end, S0, V, r] = input;
    const Vector e = end - begin;
    return r > 0.01 && norm(e) > 0.1 && norm(cross(e, S0 - begin)) > 1.001 * r * norm(e);
  };
  probes.judge = judge;
  probes.along = {"y of S0", -3, 5, [](auto& input, double at) { std::get<2>(input).y = at; }};
  return probes;
}
