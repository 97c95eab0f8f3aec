#pragma once
#include "workbook/vectors.hpp"

// 8b: one step of two discs: sweep, impact, the rest of the step. The task is in task.md.
using namespace workbook;

struct Disc {
  Vector2 place, velocity;
  double mass = 1, radius = 1;
};
struct Discs {
  Disc first, second;
};

/// When two discs that are apart first touch, at any time t >= 0, or nothing.
inline std::optional<double> meeting(const Disc& a, const Disc& b) {
  const Vector2 w = a.place - b.place, u = a.velocity - b.velocity;
  const double uu = dot(u, u), wu = dot(w, u), d = a.radius + b.radius, across = cross(w, u),
               under = uu * d * d - across * across;
  if (wu >= 0 || under < 0) return {};
  return (-wu - std::sqrt(under)) / uu;
}
/// Gives both the velocities after an impact of steel, with N from b to a, of any length.
inline void collide(Disc& a, Disc& b, Vector2 N) {
  const double s = dot(a.velocity - b.velocity, N), j = -2 * s / (dot(N, N) * (1 / a.mass + 1 / b.mass));
  a.velocity = a.velocity + j / a.mass * N;
  b.velocity = b.velocity - j / b.mass * N;
}

using Signature = Discs(const Discs& discs);
#define EXERCISE_FUNCTION step
