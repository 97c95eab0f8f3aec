// Many things at once: the same answers wherever they lie in memory. All are moved by putting others before them that
// are too far away, or too early, to matter.
#include "anywhere.hpp"
#include "catch.hpp"
#include "digest/shapes.hpp"
#include "first_contact/geometry/bounding.hpp"
#include "first_contact/motion/tween.hpp"
#include "first_contact/pairs/first_contacts.hpp"
#include "first_contact/trees/box_tree.hpp"
#include "first_contact/trees/brute_force.hpp"
#include "first_contact/trees/bsp_tree.hpp"
#include "first_contact/trees/octree.hpp"
#include "first_contact/trees/soup.hpp"

using namespace first_contact;
using namespace anywhere;
using digest::Dice;

namespace {

constexpr std::size_t most_before = 8;

template <class Thing>
std::vector<Thing> after(std::size_t count, const Thing& other, const std::vector<Thing>& things) {
  std::vector<Thing> all(count, other);
  all.insert(all.end(), things.begin(), things.end());
  return all;
}

template <class Tree>
std::uint64_t casts_among(const std::vector<Triangle>& shards, std::size_t before, std::uint64_t seed) {
  const Point far(0x1p20, 0, 0);
  const Soup<Tree> soup(after(before, {far, far, far}, shards));
  Dice dice(seed);
  Record record(false);
  for (int i = 0; i < 20; ++i) {
    const Moving<Sphere> ball = digest::ball(dice, 1);
    auto contact = sweep(ball, soup);
    if (contact) contact->triangle -= before;
    record.add(contact);
    for (const std::size_t number : near(ball, soup)) record.count(number - before);
  }
  return record.hash();
}

}  // namespace

TEST_CASE("Every tree finds the same wherever its triangles lie in memory") {
  Dice dice(51);
  for (std::uint64_t i = 0; i < 20; ++i) {
    const std::vector<Triangle> shards = digest::soup(dice, 30, 1);
    const std::uint64_t expected = casts_among<BruteForce>(shards, 0, i);
    for (std::size_t before = 0; before < most_before; ++before) {
      CAPTURE(i, before);
      CHECK(casts_among<BruteForce>(shards, before, i) == expected);
      CHECK(casts_among<Octree>(shards, before, i) == expected);
      CHECK(casts_among<BspTree>(shards, before, i) == expected);
      CHECK(casts_among<BoxTree>(shards, before, i) == expected);
    }
  }
}

TEST_CASE("All pairs are the same wherever the spheres lie in memory") {
  Dice dice(52);
  for (int i = 0; i < 6; ++i) {
    std::vector<Moving<Sphere>> balls;
    for (int k = 0; k < 40; ++k) balls.push_back(digest::ball(dice, 1));
    const auto pairs_after = [&](std::size_t before) {
      Record record(false);
      for (const PairContact& pair : first_contacts(after(before, {{{0x1p20, 0, 0}, 0}, {0, 0, 0}}, balls))) {
        record.count(pair.first - before), record.count(pair.second - before);
        record.add(pair.contact);
      }
      return record.hash();
    };
    for (std::size_t before = 1; before < most_before; ++before) CHECK(pairs_after(before) == pairs_after(0));
  }
}

TEST_CASE("A tween, a curve and what bounds some points are the same wherever the points lie in memory") {
  Dice dice(53);
  for (int i = 0; i < 50; ++i) {
    std::vector<Point> points;
    for (int k = 0; k < 6; ++k) points.push_back(dice.point());
    std::vector<KeyFrame> keys;
    for (std::size_t k = 0; k < 3; ++k)
      keys.push_back({double(k), points[k], ease::in_out_cubic, Path::bezier({points[k + 3]}, true)});
    const double moment = 2 * dice.part();
    const auto answers_after = [&](std::size_t before) {
      std::vector<KeyFrame> all;
      for (std::size_t k = before; k > 0; --k) all.push_back({-double(k), points[0]});
      all.insert(all.end(), keys.begin(), keys.end());
      const std::vector<Point> moved = after(before, points[0], points);
      const std::span<const Point> same(moved.begin() + static_cast<std::ptrdiff_t>(before), moved.end());
      Record record(false);
      record.add(Tween(all).at(moment));
      record.add(BSpline({same.begin(), same.end()}, 3).at(moment / 2));
      record.add(bounding_sphere(same).center);
      record.add(bounding_box(same).center);
      return record.hash();
    };
    for (std::size_t before = 1; before < most_before; ++before)
      CHECK(answers_after(before) == answers_after(0));
  }
}
