#include "plain_bsp.hpp"

#include <algorithm>
#include <numeric>

using namespace first_contact;

namespace partitioning_chapter {

//! [plain_bsp]
PlainBsp plain_bsp(std::span<const Triangle> all, const std::vector<std::size_t>& walls) {
  if (walls.empty()) return {};
  const std::size_t wall = walls.front();
  const Plane plane = Plane::through(all[wall].a, all[wall].area_vector());
  std::vector<std::size_t> front, back;
  for (const std::size_t other : std::span(walls).subspan(1)) {
    const auto& [a, b, c] = all[other];
    const auto [least, most] =
        std::minmax({plane.signed_distance(a), plane.signed_distance(b), plane.signed_distance(c)});
    if (most > 0) front.push_back(other);
    if (most <= 0 || least < 0) back.push_back(other);
  }
  return {plane, wall, {plain_bsp(all, front), plain_bsp(all, back)}};
}
//! [plain_bsp]

//! [plain_same_side]
std::vector<std::size_t> plain_search(const PlainBsp& tree, const Moving<Sphere>& ball) {
  if (!tree.plane) return {};
  const auto& [center, radius] = ball.shape;
  const double d1 = tree.plane->signed_distance(center);
  const double d2 = tree.plane->signed_distance(center + ball.displacement);
  if (d1 > radius && d2 > radius) return plain_search(tree.sides[0], ball);
  if (d1 < -radius && d2 < -radius) return plain_search(tree.sides[1], ball);
  std::vector<std::size_t> found{tree.wall};
  for (const PlainBsp& side : tree.sides)
    for (const std::size_t wall : plain_search(side, ball)) found.push_back(wall);
  return found;
}
//! [plain_same_side]

namespace {

// Adds to the cost what is at or below a node.
void count(const PlainBsp& tree, std::size_t depth, PlainBspCost& cost) {
  if (!tree.plane) return;
  ++cost.kept;
  cost.depth = std::max(cost.depth, depth);
  for (const PlainBsp& side : tree.sides) count(side, depth + 1, cost);
}

}  // namespace

PlainBspCost plain_bsp_costs(std::span<const Triangle> walls, std::span<const Moving<Sphere>> flights) {
  std::vector<std::size_t> all(walls.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const PlainBsp tree = plain_bsp(walls, all);
  PlainBspCost cost{0, 0, 0};
  count(tree, 0, cost);
  for (const Moving<Sphere>& ball : flights) cost.found += plain_search(tree, ball).size();
  return cost;
}

}  // namespace partitioning_chapter
