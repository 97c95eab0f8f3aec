// The range of numbers that contact.hpp promises, at its ends: the trees. Each is the same tree in every unit, finds
// the same, and looks at as much for it.
#include "first_contact/pairs/first_contacts.hpp"
#include "first_contact/trees/box_tree.hpp"
#include "first_contact/trees/brute_force.hpp"
#include "first_contact/trees/bsp_tree.hpp"
#include "first_contact/trees/objects.hpp"
#include "first_contact/trees/octree.hpp"
#include "first_contact/trees/plain_bvh.hpp"
#include "first_contact/trees/soup.hpp"
#include "property/in_units.hpp"

using namespace first_contact;
using namespace in_units;

namespace {

std::vector<Triangle> shards(Scene& scene, int count) {
  std::vector<Triangle> all;
  for (int i = 0; i < count; ++i) {
    const Point at = scene.vector(4), b = at + scene.vector(0.75), c = at + scene.vector(0.75);
    all.push_back({at, b, c});
  }
  return all;
}

template <class Tree>
void check_soup(Scene& scene) {
  const std::vector<Triangle> some = shards(scene, 60);
  const Soup<Tree> soup(some);
  std::vector<Moving<Sphere>> balls;
  for (int i = 0; i < 5; ++i) balls.push_back(scene.ball());
  for (const int power : powers) {
    CAPTURE(power);
    const Soup<Tree> large(times(some, power));
    REQUIRE(large.tree().nodes() == soup.tree().nodes());
    REQUIRE(large.tree().depth() == soup.tree().depth());
    REQUIRE(large.tree().work() == soup.tree().work());
    for (const Moving<Sphere>& ball : balls) {
      Statistics before, after;
      const auto contact = sweep(ball, soup, &before);
      check_scaled(sweep(times(ball, power), large, &after), contact, power);
      REQUIRE(after == before);
      const Bounds box = bounds_of(ball.shape);
      REQUIRE(near(times(ball, power), large) == near(ball, soup));
      REQUIRE(near(times(box, power), large, &after) == near(box, soup, &before));
      REQUIRE(after == before);
    }
  }
}

template <class Tree>
void check_objects(Scene& scene) {
  std::vector<Bounds> some;
  for (const Triangle& shard : shards(scene, 60)) some.push_back(bounds_of(shard));
  const Objects<Tree> objects(some);
  const Moving<Sphere> ball = scene.ball();
  for (const int power : powers) {
    CAPTURE(power);
    const Objects<Tree> large(times(some, power));
    REQUIRE(large.tree().nodes() == objects.tree().nodes());
    REQUIRE(large.tree().work() == objects.tree().work());
    REQUIRE(pairs(large) == pairs(objects));
    Statistics before, after;
    REQUIRE(near(times(ball, power), large, &after) == near(ball, objects, &before));
    REQUIRE(after == before);
  }
}

}  // namespace

TEST_CASE("An octree over triangles, or over boxes, is the same in every unit, and finds the same") {
  in_every_unit(1320, 20, [](Scene& scene) { check_soup<Octree>(scene), check_objects<Octree>(scene); });
}

TEST_CASE("A BSP tree is the same in every unit, and finds the same") {
  in_every_unit(1321, 20, [](Scene& scene) { check_soup<BspTree>(scene); });
}

TEST_CASE("A tree of boxes over triangles, or over boxes, is the same in every unit, and finds the same") {
  in_every_unit(1322, 20, [](Scene& scene) { check_soup<BoxTree>(scene), check_objects<BoxTree>(scene); });
}

TEST_CASE("Without a tree the same is found in every unit") {
  in_every_unit(1323, 20,
                [](Scene& scene) { check_soup<BruteForce>(scene), check_objects<BruteForce>(scene); });
}

TEST_CASE("The plain tree of a mesh shows the same triangles in every unit") {
  in_every_unit(1324, 100, [](Scene& scene) {
    const Mesh mesh = scene.mesh();
    const Moving<Sphere> ball = scene.ball();
    const auto shown = [&](int power) {
      std::vector<std::uint32_t> triangles;
      PlainBvh(times(mesh, power)).visit(times(ball, power), [&](std::uint32_t triangle) {
        triangles.push_back(triangle);
        return 1.0;
      });
      return triangles;
    };
    for (const int power : powers) {
      CAPTURE(power);
      REQUIRE(shown(power) == shown(0));
    }
  });
}

TEST_CASE("All pairs cost the same tests in every unit") {
  in_every_unit(1325, 20, [](Scene& scene) {
    std::vector<Moving<Sphere>> balls;
    for (int k = 0; k < 60; ++k) {
      const Moving<Sphere> ball = scene.ball();
      balls.push_back({{ball.shape.center + 3 * scene.vector(1), ball.shape.radius / 4}, ball.displacement});
    }
    PairStatistics before, after;
    const auto found = first_contacts(balls, &before);
    for (const int power : powers) {
      CAPTURE(power);
      REQUIRE(first_contacts(times(balls, power), &after).size() == found.size());
      REQUIRE(after.pieces == before.pieces);
      REQUIRE(after.boxes == before.boxes);
      REQUIRE(after.sweeps == before.sweeps);
    }
  });
}
