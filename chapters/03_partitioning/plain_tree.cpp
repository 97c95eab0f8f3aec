#include "plain_tree.hpp"

#include <algorithm>
#include <numeric>

using namespace first_contact;

namespace partitioning_chapter {

//! [plain_cut]
PlainTree plain_tree(std::span<const Bounds> all, std::vector<std::size_t> things) {
  PlainTree tree;
  for (const std::size_t thing : things) tree.box.extend(all[thing]);
  if (things.size() <= 4) {
    tree.things = things;
    return tree;
  }
  Eigen::Index axis = 0;
  tree.box.sizes().maxCoeff(&axis);  // its longest side
  const auto middle = things.begin() + std::ssize(things) / 2;
  std::nth_element(things.begin(), middle, things.end(), [&](std::size_t a, std::size_t b) {
    return middle_of(all[a])[axis] < middle_of(all[b])[axis];
  });
  tree.parts.push_back(plain_tree(all, {things.begin(), middle}));
  tree.parts.push_back(plain_tree(all, {middle, things.end()}));
  return tree;
}
//! [plain_cut]

//! [plain_search]
std::vector<std::size_t> plain_search(const PlainTree& tree, const Moving<Sphere>& ball) {
  const auto& [center, radius] = ball.shape;
  if (!passage(center, ball.displacement, grown(tree.box, radius), {0, 1})) return {};
  std::vector<std::size_t> found = tree.things;
  for (const PlainTree& part : tree.parts)
    for (const std::size_t thing : plain_search(part, ball)) found.push_back(thing);
  return found;
}
//! [plain_search]

std::size_t plain_tests(std::span<const Triangle> triangles, std::span<const Moving<Sphere>> flights) {
  std::vector<Bounds> bounds;
  for (const Triangle& triangle : triangles) bounds.push_back(bounds_of(triangle));
  std::vector<std::size_t> things(triangles.size());
  std::iota(things.begin(), things.end(), std::size_t{0});
  const PlainTree tree = plain_tree(bounds, things);
  std::size_t tests = 0;
  for (const Moving<Sphere>& ball : flights) tests += plain_search(tree, ball).size();
  return tests;
}

}  // namespace partitioning_chapter
