#include "walls.hpp"

#include <array>

using namespace first_contact;

namespace {

constexpr double half_height = 0.1;
constexpr std::array<std::array<double, 4>, 14> ends{{{0.4, 5.1, 1.2, 5.3},
                                                      {0.3, 3.3, 0.7, 2.4},
                                                      {0.9, 3.9, 1.5, 4.3},
                                                      {0.5, 0.6, 1.1, 0.9},
                                                      {1.5, 1.4, 1.8, 0.5},
                                                      {1.8, 3.0, 2.3, 2.5},
                                                      {2.2, 5.2, 2.6, 4.5},
                                                      {2.9, 3.6, 3.2, 4.0},
                                                      {2.8, 0.7, 3.4, 1.1},
                                                      {3.8, 4.9, 4.5, 5.2},
                                                      {4.1, 3.3, 4.4, 4.0},
                                                      {4.2, 1.0, 4.7, 0.3},
                                                      {5.1, 3.0, 5.7, 2.8},
                                                      {5.5, 4.8, 6.0, 4.3}}};

std::vector<Triangle> standing_walls() {
  std::vector<Triangle> all;
  for (const auto& [x0, y0, x1, y1] : ends)
    all.emplace_back(Point(x0, y0, -half_height), Point(x1, y1, 0), Point(x0, y0, half_height));
  return all;
}

Bounds around(const std::vector<Triangle>& triangles) {
  Bounds all;
  for (const Triangle& triangle : triangles) all.extend(bounds_of(triangle));
  return all;
}

}  // namespace

namespace partitioning_chapter {

Yard::Yard()
    : walls(standing_walls()),
      bounds(around(walls)),
      octree(walls, OctreeLimits{1, 20}),
      bsp(walls, BspLimits{1, 64, 16, 8}),
      bvh(walls, BoxTreeLimits{1}) {}

Moving<Sphere> Roll::ball() const {
  return {{{from.x(), from.y(), 0}, radius}, {to.x() - from.x(), to.y() - from.y(), 0}};
}

std::vector<Point> part_of(const std::vector<Point>& region, const Plane& plane, double side) {
  std::vector<Point> part;
  for (std::size_t i = 0; i < region.size(); ++i) {
    const Point &p = region[i], &q = region[(i + 1) % region.size()];
    const double at_p = side * plane.signed_distance(p), at_q = side * plane.signed_distance(q);
    if (at_p >= 0) part.push_back(p);
    if ((at_p > 0) != (at_q > 0)) part.emplace_back(p + at_p / (at_p - at_q) * (q - p));
  }
  return part;
}

}  // namespace partitioning_chapter
