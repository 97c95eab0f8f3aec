#pragma once
#include "task.hpp"
#include "workbook/sheet_of.hpp"

/// The judge computes the meeting and the impact as seen from the centre of mass.
inline Discs judge(const Discs& discs) {
  Discs after = discs;
  auto& [a, b] = after;
  const Vector2 w = a.place - b.place, u = a.velocity - b.velocity,
                common = (a.mass * a.velocity + b.mass * b.velocity) / (a.mass + b.mass);
  const double speed = norm(u), d = a.radius + b.radius;
  double t = 2;
  if (speed > 0 && dot(w, u) < 0) {
    const double beside = std::abs(cross(w, u)) / speed;
    if (beside < d) t = (-dot(w, u) / speed - std::sqrt(d * d - beside * beside)) / speed;
  }
  const double first = std::min(t, 1.0);
  a.place = a.place + first * a.velocity, b.place = b.place + first * b.velocity;
  if (t > 1) return after;
  const Vector2 n = (a.place - b.place) / norm(a.place - b.place);
  a.velocity = a.velocity - 2 * dot(a.velocity - common, n) * n;
  b.velocity = b.velocity - 2 * dot(b.velocity - common, n) * n;
  a.place = a.place + (1 - t) * a.velocity, b.place = b.place + (1 - t) * b.velocity;
  return after;
}

inline Exercise<Signature> exercise() {
  Exercise<Signature> probes;
  probes.asked = "both discs after one unit of time: (place, velocity, mass, radius) of each";
  probes.names = {"discs"};
  probes.chosen = {
      {"head on, equal masses", {Discs{{{-4, 0}, {6, 0}, 1, 1}, {{4, 0}, {-6, 0}, 1, 1}}}},
      {"they do not come so far in this step", {Discs{{{-4, 0}, {1, 0}, 1, 1}, {{4, 0}, {-1, 0}, 1, 1}}}},
      {"they would meet just after the step", {Discs{{{-4, 0}, {2, 0}, 1, 1}, {{4, 0}, {-2, 0}, 1, 1}}}},
      {"they part", {Discs{{{-4, 0}, {-1, 0}, 1, 1}, {{4, 0}, {1, 0}, 1, 1}}}},
      {"they approach, and pass each other by", {Discs{{{-4, 3}, {6, 0}, 1, 1}, {{4, 0}, {-6, 0}, 1, 1}}}},
      {"aimed a radius beside the middle: the normal turns on the way",
       {Discs{{{-5, 1}, {5, 0}, 1, 1}, {{0, 0}, {0, 0}, 1, 1}}}},
      {"a heavy one meets a light one", {Discs{{{-4, 0.5}, {6, 0}, 5, 1}, {{4, 0}, {-6, 1}, 1, 1}}}},
      {"discs of different radii", {Discs{{{-4, 0.5}, {6, 0}, 1, 0.5}, {{4, 0}, {-6, 1}, 2, 2}}}},
      {"early in the step, with much of it left",
       {Discs{{{-2.25, 0}, {8, 0}, 1, 1}, {{0, 0.5}, {0, 0}, 1, 1}}}},
  };
  probes.random = [](Chance& chance) {
    const Disc a{chance.vector2(4), {}, chance.number(0.5, 5), chance.number(0.5, 1.5)};
    Disc first = a, second{chance.vector2(4), {}, chance.number(0.5, 5), chance.number(0.5, 1.5)};
    first.velocity = 1.5 * (second.place - first.place) + chance.vector2(2),
    second.velocity = chance.vector2(3);
    return std::tuple{Discs{first, second}};
  };
  probes.allowed = [](const auto& input) {
    const auto& [a, b] = std::get<0>(input);
    return a.mass > 0.1 && b.mass > 0.1 && a.radius > 0.05 && b.radius > 0.05 &&
           norm(a.place - b.place) > a.radius + b.radius + 0.01;
  };
  probes.judge = judge;
  probes.unit = Unit::scene;
  probes.along = {"y of the first place (x of it afterwards)", -3, 3,
                  [](auto& input, double at) { std::get<0>(input).first.place.y = at; }};
  return probes;
}
