#pragma once
#include "task.hpp"
#include "workbook/sheet_of.hpp"

/// The nearest point of a triangle, and so the distance.
inline double distance_of_segment(Point a, Point b, Point P) {
  const double s = std::clamp(dot(P - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
  return norm(a + s * (b - a) - P);
}
inline double distance_of(const Triangle& triangle, Point P) {
  const auto& [a, b, c] = triangle;
  const Vector N = cross(b - a, c - a) / norm(cross(b - a, c - a));
  const double u = dot(N, cross(b - a, P - a)), v = dot(N, cross(c - b, P - b)),
               w = dot(N, cross(a - c, P - c));
  if (u >= 0 && v >= 0 && w >= 0) return std::abs(dot(N, P - a));
  return std::min({distance_of_segment(a, b, P), distance_of_segment(b, c, P), distance_of_segment(c, a, P)});
}

/// The judge knows neither faces nor edges: it goes on by the distance that is left, and halves at the end.
/// The distance
/// of one convex thing from a point on a straight way is a convex function, so it never steps over a touch.
inline std::optional<double> touch_one(const Triangle& triangle, Point S0, Vector V, double r) {
  const double speed = norm(V);
  double t = 0;
  for (int step = 0; step < 2000 && t <= 1; ++step) {
    const double gap = distance_of(triangle, S0 + t * V) - r;
    if (gap < 1e-12) return t;
    t += gap / speed;
  }
  return {};
}
inline std::optional<double> judge(const std::vector<Triangle>& soup, Point S0, Vector V, double r) {
  std::optional<double> first;
  if (norm(V) == 0) return first;
  for (const Triangle& triangle : soup)
    if (const auto t = touch_one(triangle, S0, V, r); t && (!first || *t < *first)) first = t;
  return first;
}

inline std::vector<Exercise<Signature>::Chosen> chosen() {
  const Triangle floor{{-4, -4, 0}, {4, -4, 0}, {0, 4, 0}}, step{{-4, -4, 1}, {4, -4, 1}, {0, 4, 1}};
  const Triangle blade{{0, 1, 1}, {-1, 1, -3}, {1, 1, -3}}, ridge{{-3, 0, 1}, {3, 0, 1}, {0, 0, -3}};
  return {
      {"a face from above", {{floor}, {0, -1, 3}, {0, 0, -4}, 0.5}},
      {"an edge from above: the ridge of a blade", {{ridge}, {0.25, 0, 3}, {0, 0, -4}, 0.5}},
      {"an edge beside the ball's path", {{ridge}, {0.25, 0.25, 3}, {0, 0, -4}, 0.5}},
      {"the second edge of a triangle",
       {{{{0, 0, -3}, {-3, 0, 1}, {3, 0, 1}}}, {0.25, 0.25, 3}, {0, 0, -4}, 0.5}},
      {"the third edge of a triangle",
       {{{{3, 0, 1}, {0, 0, -3}, {-3, 0, 1}}}, {0.25, 0.25, 3}, {0, 0, -4}, 0.5}},
      {"a vertex from above: the tip of a blade", {{blade}, {0.125, 1.25, 3}, {0, 0, -4}, 0.5}},
      {"two floors, the nearer one listed second", {{floor, step}, {0, -1, 3}, {0, 0, -4}, 0.5}},
      {"two floors, the nearer one listed first", {{step, floor}, {0, -1, 3}, {0, 0, -4}, 0.5}},
      {"the tip of a blade that stands on a floor: the vertex comes before the face",
       {{floor, blade}, {0.125, 1.25, 3}, {0, 0, -4}, 0.5}},
      {"a ridge over a floor: the edge comes before the face",
       {{floor, ridge}, {0.25, 0.25, 3}, {0, 0, -4}, 0.5}},
      {"a tip beside a ridge: the edge is listed first, the vertex is touched first",
       {{{{-3, 3, 0.5}, {3, 3, 0.5}, {0, 3, -3}}, {{0, 2.875, 1}, {-1, 2.75, -3}, {1, 2.75, -3}}},
        {0.125, 2.875, 3},
        {0, 0, -4},
        0.5}},
      {"nothing on the way", {{floor, blade}, {9, 9, 3}, {0, 0, -4}, 0.5}},
      {"no triangle at all", {{}, {0, 0, 3}, {0, 0, -4}, 0.5}},
      {"a motion that ends too early", {{floor}, {0, -1, 3}, {0, 0, -1}, 0.5}},
  };
}

inline Exercise<Signature> exercise() {
  Exercise<Signature> probes;
  probes.asked = "the first t in [0, 1] at which the ball touches any triangle: its face, an edge, a vertex";
  probes.names = {"soup", "S0", "V", "r"};
  probes.chosen = chosen();
  probes.random = [](Chance& chance) {
    std::vector<Triangle> soup;
    for (std::size_t n = 1 + chance.below(4); n > 0; --n) {
      const Point middle = chance.vector(3);
      soup.push_back({middle + chance.vector(2), middle + chance.vector(2), middle + chance.vector(2)});
    }
    const Point S0 = chance.vector(6);
    return std::tuple{soup, S0, chance.vector(2) - 1.5 * S0, chance.number(0.25, 1)};
  };
  probes.allowed = [](const auto& input) {
    const auto& [soup, S0, V, r] = input;
    for (const Triangle& each : soup)
      if (norm(cross(each.b - each.a, each.c - each.a)) < 0.5 || distance_of(each, S0) < r + 0.01)
        return false;
    return r > 0.1;
  };
  probes.judge = judge;
  probes.tolerance = 1e-6;
  probes.along = {"x of S0", -5, 5, [](auto& input, double at) { std::get<1>(input).x = at; }};
  return probes;
}
