#include "first_contact/pairs/first_contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "catch.hpp"
#include "chance.hpp"
#include "first_contact/sweep/sphere_sphere.hpp"

using namespace first_contact;

namespace {

using Balls = std::vector<Moving<Sphere>>;

bool alike(const std::vector<PairContact>& a, const std::vector<PairContact>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const PairContact& x, const PairContact& y) {
    return x.first == y.first && x.second == y.second && x.contact.time == y.contact.time &&
           x.contact.normal == y.contact.normal && x.contact.point() == y.contact.point();
  });
}

/// All contacts and the earliest, against brute force; returns how many there are.
std::size_t check(const Balls& balls) {
  const auto found = first_contacts(balls), truth = first_contacts_one_by_one(balls);
  REQUIRE(found.size() == truth.size());
  REQUIRE(alike(found, truth));
  const auto earliest = earliest_contact(balls);
  REQUIRE(earliest.has_value() == !truth.empty());
  if (earliest) REQUIRE(alike({*earliest}, {truth.front()}));
  return truth.size();
}

/// As many balls as wished, at a density that does not depend on their number.
Balls gas(Chance& chance, std::size_t count, double radius, double speed) {
  const double half = 0.5 * std::cbrt(static_cast<double>(count));
  Balls balls;
  for (std::size_t i = 0; i < count; ++i)
    balls.push_back({{chance.vector(half), chance.uniform(0, radius)}, chance.vector(speed)});
  return balls;
}

/// Two balls that meet, or nearly, at `time`, grazing by a relative `depth`; far from the origin.
void add_graze(Balls& balls, Chance& chance, double time, double depth, double away) {
  const Vector u = chance.vector(2), across = u.unitOrthogonal();
  const double rp = chance.uniform(0, 0.2), rq = chance.uniform(0, 0.2), d = rp + rq;
  const double miss = d * (1 - depth), chord = std::sqrt(std::max(0.0, d * d - miss * miss));
  const Point q = chance.vector(away);
  const Vector common = chance.vector(1);
  const Vector arrival = miss * across - chord * u.normalized();
  balls.push_back({{q + arrival - time * u, rp}, u + common});
  balls.push_back({{q, rq}, common});
}

}  // namespace

TEST_CASE("The contacts of random spheres are those of brute force, bit for bit", "[first_contacts]") {
  std::size_t contacts = 0;
  for (unsigned seed = 1; seed <= 150; ++seed) {
    CAPTURE(seed);
    Chance chance(seed);
    const auto count = static_cast<std::size_t>(std::pow(10, chance.uniform(0, 2.7)));
    contacts +=
        check(gas(chance, count, std::pow(10, chance.uniform(-2, 0)), std::pow(10, chance.uniform(-1, 1.5))));
  }
  CHECK(contacts > 1000);
}

TEST_CASE(
    "One sphere as large as all space, one that is far away, and a few that are very fast change nothing",
    "[first_contacts]") {
  std::size_t contacts = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    Chance chance(seed);
    Balls balls = gas(chance, 300, 0.3, 1);
    balls.push_back({{chance.vector(1), 3}, chance.vector(5)});
    balls.push_back({{chance.vector(1e6), 0.1}, chance.vector(1e6)});
    for (int i = 0; i < 5; ++i) balls.push_back({{chance.vector(3), 0.1}, chance.vector(1e3)});
    for (int i = 0; i < 5; ++i) balls.push_back({{chance.vector(1e4), 1}, chance.vector(2e4)});
    contacts += check(balls);
  }
  CHECK(contacts > 1000);
}

TEST_CASE("Spheres in a plane, on a line, on a grid and in one heap: as brute force", "[first_contacts]") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    Chance chance(seed);
    Balls flat = gas(chance, 200, 0.3, 1), line = flat, grid = flat, heap = flat;
    for (auto& ball : flat) ball.shape.center.z() = ball.displacement.z() = 0;
    for (auto& ball : line) ball.shape.center.tail<2>().setZero();
    for (auto& ball : grid) {
      ball.shape.center = ball.shape.center.array().round();
      ball.displacement = ball.displacement.array().round();
      ball.shape.radius = 0.5;
    }
    for (auto& ball : heap) ball.shape.center *= 1e-3;
    for (const Balls& balls : {flat, line, grid, heap}) check(balls);
  }
}

TEST_CASE("Grazing contacts at the ends and at the seams of pieces, near and far, are those of brute force",
          "[first_contacts]") {
  std::size_t contacts = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    Chance chance(seed);
    Balls balls;
    const double away = std::pow(10, chance.uniform(0, 6));
    for (int i = 0; i < 150; ++i) {
      const double depth = std::copysign(std::pow(10, chance.uniform(-17, -2)), chance.uniform(-1, 2));
      add_graze(balls, chance, std::round(chance.uniform(0, 8)) / 8, depth, away);
    }
    contacts += check(balls);
  }
  CHECK(contacts > 2000);
}

TEST_CASE("The contacts do not depend on the order of the spheres, but for who is the mover",
          "[first_contacts]") {
  Chance chance(7);
  const Balls balls = gas(chance, 500, 0.4, 2);
  std::vector<std::size_t> order(balls.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  chance.shuffle(order);
  Balls shuffled;
  for (const std::size_t i : order) shuffled.push_back(balls[i]);
  const auto found = first_contacts(balls), again = first_contacts(shuffled);
  REQUIRE(found.size() == again.size());
  std::vector<std::pair<std::size_t, std::size_t>> a, b;
  for (const auto& pair : found) a.emplace_back(pair.first, pair.second);
  for (const auto& pair : again) b.push_back(std::minmax(order[pair.first], order[pair.second]));
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  CHECK(a == b);
}

TEST_CASE("A scene scaled by a power of two has the same contacts, found by the same tests",
          "[first_contacts]") {
  const double scale = GENERATE(0x1p-100, 0x1p-10, 0x1p10, 0x1p100);
  Chance chance(8);
  const Balls balls = gas(chance, 400, 0.4, 5);
  Balls scaled;
  for (const auto& ball : balls)
    scaled.push_back({{ball.shape.center * scale, ball.shape.radius * scale}, ball.displacement * scale});
  PairStatistics a, b;
  const auto found = first_contacts(balls, &a), again = first_contacts(scaled, &b);
  REQUIRE(found.size() == again.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    REQUIRE(found[i].contact.time == again[i].contact.time);
    REQUIRE(found[i].contact.point() * scale == again[i].contact.point());
  }
  CHECK(a.pieces == b.pieces);
  CHECK(a.boxes == b.boxes);
  CHECK(a.sweeps == b.sweeps);
}

TEST_CASE("The tests grow like n log n, also with one sphere as large as all space", "[first_contacts]") {
  const bool with_a_large_one = GENERATE(false, true);
  for (const std::size_t count : {500U, 2000U, 8000U, 32000U}) {
    CAPTURE(count);
    Chance chance(9);
    Balls balls = gas(chance, count, 0.3, 1);
    if (with_a_large_one) balls[0].shape.radius = std::cbrt(static_cast<double>(count));
    PairStatistics counted;
    first_contacts(balls, &counted);
    const double n = static_cast<double>(count);
    CHECK(static_cast<double>(counted.boxes) < 6 * n * std::log2(n));
    CHECK(static_cast<double>(counted.sweeps) < 6 * n);
    CHECK(static_cast<double>(counted.pieces) <= 17 * n);
  }
}

TEST_CASE("Of slow, fast and flat crowds no more is cut, tested and swept than was", "[first_contacts]") {
  struct Scene {
    double radius, speed, height;  // of a layer, in terms of its width
    std::array<double, 3> expected;
  };
  for (const Scene& scene :
       {Scene{0.3, 0.1, 1, {2000, 27075, 425}}, Scene{0.05, 30, 1, {24831, 1004229, 37841}},
        Scene{0.3, 2, 0.01, {5371, 366234, 65398}}, Scene{0.3, 2, 50, {4428, 122057, 5985}}}) {
    Chance chance(10);
    Balls balls = gas(chance, 2000, scene.radius, scene.speed);
    for (auto& ball : balls) ball.shape.center.z() *= scene.height, ball.displacement.z() *= scene.height;
    PairStatistics counted;
    first_contacts(balls, &counted);
    const std::array<std::size_t, 3> work{counted.pieces, counted.boxes, counted.sweeps};
    CAPTURE(scene.speed, scene.height, work);
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(std::abs(static_cast<double>(work[i]) - scene.expected[i]) <= 0.005 * scene.expected[i]);
  }
}

TEST_CASE("Balls that graze each other along an axis, while both fly far, are those of brute force",
          "[first_contacts]") {
  // Their boxes then share no more than what rounding leaves: the boxes' margins alone find them.
  std::size_t contacts = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    Chance chance(seed);
    const double away = chance.log_uniform(1e-3, 1e3), fast = chance.log_uniform(1e-3, 1e6);
    Balls balls;
    for (int i = 0; i < 100; ++i) {
      const double rp = chance.uniform(0, 0.2), rq = chance.uniform(0, 0.2),
                   depth = chance.log_uniform(1e-17, 1e-12);
      Vector across = Vector::Zero(), u = Vector::Zero();
      const auto axis = static_cast<Eigen::Index>(chance.pick(3));
      across[axis] = (rp + rq) * (1 - depth) * (chance.pick(2) ? 1 : -1);
      u[(axis + 1) % 3] = chance.uniform(0.5, 2);
      const Point q = chance.vector(away);
      const Vector common = chance.vector(fast);
      balls.push_back({{q + across - chance.uniform(0, 1) * u, rp}, u + common});
      balls.push_back({{q, rq}, common});
    }
    contacts += check(balls);
  }
  CHECK(contacts > 1000);
}
