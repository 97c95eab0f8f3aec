#pragma once
#include "workbook/vectors.hpp"

// 4c: when does a ball first touch a soup of triangles? The task is in task.md.
using namespace workbook;

struct Triangle {
  Point a, b, c;
};

/// When a ball that starts clear of it, and moves from S0 to S0 + V, touches a face in its inside; a vertex;
/// or an edge
/// between its ends; within [0, 1], or nothing.
inline std::optional<double> touch_vertex(Point a, Point S0, Vector V, double r) {
  const Vector m = S0 - a;
  const double vv = dot(V, V), mv = dot(m, V), under = vv * r * r - dot(cross(m, V), cross(m, V));
  if (mv >= 0 || under < 0 || -mv - std::sqrt(under) > vv) return {};
  return (-mv - std::sqrt(under)) / vv;
}
inline std::optional<double> touch_edge(Point a, Point b, Point S0, Vector V, double r) {
  const Vector e = b - a;
  const auto t = touch_vertex({}, cross(e, S0 - a), cross(e, V), norm(e) * r);
  if (!t || dot(S0 + *t * V - a, e) < 0 || dot(S0 + *t * V - b, e) > 0) return {};
  return t;
}
inline std::optional<double> touch_face(const Triangle& triangle, Point S0, Vector V, double r) {
  const auto& [a, b, c] = triangle;
  Vector N = cross(b - a, c - a) / norm(cross(b - a, c - a));
  if (dot(N, S0 - a) < 0) N = -N;
  const double t = (r - dot(N, S0 - a)) / dot(N, V);
  if (!(t >= 0 && t <= 1 && dot(N, V) < 0)) return {};
  const Point C = S0 + t * V - r * N;
  const double u = dot(N, cross(b - a, C - a)), v = dot(N, cross(c - b, C - b)),
               w = dot(N, cross(a - c, C - c));
  if ((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0)) return t;
  return {};
}

using Signature = std::optional<double>(const std::vector<Triangle>& soup, Point S0, Vector V, double r);
#define EXERCISE_FUNCTION touch_soup
