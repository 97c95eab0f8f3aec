#include "walls.hpp"

#include <array>

using namespace first_contact;

namespace {

constexpr double half_height = 0.1;
// In tenths: from x, y to x, y.
constexpr std::array<std::array<signed char, 4>, 14> ends{{{4, 51, 12, 53},
                                                           {3, 33, 7, 24},
                                                           {9, 39, 15, 43},
                                                           {5, 6, 11, 9},
                                                           {15, 14, 18, 5},
                                                           {18, 30, 23, 25},
                                                           {22, 52, 26, 45},
                                                           {29, 36, 32, 40},
                                                           {28, 7, 34, 11},
                                                           {38, 49, 45, 52},
                                                           {41, 33, 44, 40},
                                                           {42, 10, 47, 3},
                                                           {51, 30, 57, 28},
                                                           {55, 48, 60, 43}}};

std::vector<Triangle> standing_walls() {
  std::vector<Triangle> all;
  for (const auto& [x0, y0, x1, y1] : ends)
    all.emplace_back(Point(x0 / 10.0, y0 / 10.0, -half_height), Point(x1 / 10.0, y1 / 10.0, 0),
                     Point(x0 / 10.0, y0 / 10.0, half_height));
  return all;
}

}  // namespace

namespace partitioning_chapter {

Yard::Yard()
    : walls(standing_walls()),
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
    if ((at_p > 0) != (at_q > 0)) part.push_back(p + at_p / (at_p - at_q) * (q - p));
  }
  return part;
}

}  // namespace partitioning_chapter
