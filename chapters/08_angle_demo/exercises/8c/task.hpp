#pragma once
#include "workbook/vectors.hpp"

// 8c: which impacts happen among many discs, one after the other? The task is in task.md.
using namespace workbook;

struct Disc {
  Vector2 place, velocity;
  double radius = 1;
};
struct Impact {
  double time = 0;
  int first = 0, second = 0;
};

/// How long it takes until two discs touch that come nearer to each other, or nothing. Two that touch
/// already, and come
/// nearer, touch after 0.
inline std::optional<double> meeting(const Disc& a, const Disc& b) {
  const Vector2 w = a.place - b.place, u = a.velocity - b.velocity;
  const double uu = dot(u, u), wu = dot(w, u), d = a.radius + b.radius, across = cross(w, u),
               under = uu * d * d - across * across;
  if (wu >= 0 || under < 0) return {};
  return std::max(0.0, (-wu - std::sqrt(under)) / uu);
}
/// An impact of steel between two discs of one mass: along their normal they exchange their velocities.
inline void collide(Disc& a, Disc& b) {
  const Vector2 N = a.place - b.place;
  const Vector2 part = dot(a.velocity - b.velocity, N) / dot(N, N) * N;
  a.velocity = a.velocity - part;
  b.velocity = b.velocity + part;
}

using Signature = std::vector<Impact>(std::vector<Disc> discs, double until);
#define EXERCISE_FUNCTION impacts
