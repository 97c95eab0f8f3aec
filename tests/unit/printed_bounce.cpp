#include "07_tween_bounce/printed_bounce.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "catch.hpp"
#include "places.hpp"

using namespace first_contact;

namespace {

// What an interpreter of MATLAB's language computed with the loop of the programs.
// \see tests/data
struct Table {
  struct Row {
    std::size_t sample;
    double t, y;
  };
  std::size_t hits = 0;
  std::vector<Row> rows;
};

double from_bits(const std::string& hexadecimal) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(std::stoull(hexadecimal, nullptr, 16)));
}

Table read_table(const std::string& name) {
  std::ifstream in(std::string(first_contact::places::source) + "/tests/data/" + name);
  Table table;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string first, t, y;
    words >> first >> t >> y;
    if (first == "#") {
      if (t == "hits:") table.hits = std::stoul(y);
    } else {
      table.rows.push_back({std::stoul(first), from_bits(t), from_bits(y)});
    }
  }
  return table;
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

void check_against(const std::string& name, const PrintedBounce& bounce, std::size_t rows) {
  const Table table = read_table(name);
  const PrintedMotion motion = run(bounce);
  REQUIRE(table.rows.size() == rows);
  CHECK(motion.y.size() == bounce.samples);
  CHECK(motion.hits.size() == table.hits);
  for (const auto& [sample, t, y] : table.rows) {
    CAPTURE(sample);
    CHECK(same_bits(motion.t[sample - 1], t));
    CHECK(same_bits(motion.y[sample - 1], y));
  }
  for (std::size_t i = table.rows[rows - 2].sample; i < motion.y.size(); ++i) CHECK(motion.y[i] == 0);
}

}  // namespace

TEST_CASE("The fall and rebound of programs 1 to 3 agree with a MATLAB interpreter to the last bit") {
  check_against("bounce-paper.txt", {}, 374);
}
TEST_CASE("Another ball on another planet agrees with the interpreter to the last bit") {
  check_against("bounce-mars.txt", {40, 30, 3.71, 0.02, 500, 0.5}, 413);
}

TEST_CASE("The printed fall has the numbers that the paper's programs give") {
  const PrintedMotion motion = run({});
  CHECK(motion.y[1] == Approx(24.500982).epsilon(1e-14));
  REQUIRE(motion.hits.size() == 1630);
  CHECK(motion.hits[0].sample == 54);
  CHECK(motion.hits[0].time == Approx(0.53).epsilon(1e-12));
  CHECK(motion.hits[0].speed == Approx(44.7954).epsilon(1e-9));  // slower than it was thrown
  CHECK(motion.hits[1].sample == 372);
  CHECK(motion.hits[1].time == Approx(3.71).epsilon(1e-12));
  for (std::size_t i = 2; i < 1630; ++i) CHECK(motion.hits[i].sample == 371 + i);
}

TEST_CASE("The printed rebound has one apex, and the ball lies on the floor from its second hit on") {
  const PrintedMotion motion = run({});
  const auto tops = apexes(motion);
  REQUIRE(tops.size() == 1);
  CHECK(tops[0].time == Approx(2.12).epsilon(1e-12));
  CHECK(tops[0].height == Approx(14.8303752).epsilon(1e-12));
  CHECK(*rest_time(motion) == motion.hits[1].time);
}

TEST_CASE(
    "The printed rebound rises to (e v0 - 6/5 g t1)^2 / (12/5 g): by the throw, the time of the fall, e and "
    "6/5") {
  for (const double e : {0.3, 0.5, 0.9}) {
    PrintedBounce bounce;
    bounce.restitution = e;
    bounce.dt = 1e-5;
    bounce.samples = 500000;
    const PrintedMotion motion = run(bounce);
    const double up = e * bounce.v0 - 6.0 / 5 * bounce.g * motion.hits.front().time;
    CHECK(apexes(motion).front().height == Approx(up * up / (12.0 / 5 * bounce.g)).epsilon(1e-4));
  }
}

TEST_CASE("A printed motion that ends in the air has no rest") {
  CHECK_FALSE(rest_time(run({50, 25, 9.82, 0.01, 100, 0.5})));
  CHECK_FALSE(rest_time(run({50, 25, 9.82, 0.01, 1, 0.5})));
}

TEST_CASE("As printed, a ball that is let go rises: gravity has the wrong sign") {
  const PrintedMotion motion = run({0, 25, 9.82, 0.01, 100, 0.5});
  CHECK(motion.y.back() > 29);
}

TEST_CASE("A printed bounce refuses values that make no sense, and names them") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(run({nan, 25, 9.82, 0.01, 10, 0.5}), std::invalid_argument);
  CHECK_THROWS_AS(run({50, -1, 9.82, 0.01, 10, 0.5}), std::invalid_argument);
  CHECK_THROWS_AS(run({50, 25, -9.82, 0.01, 10, 0.5}), std::invalid_argument);
  CHECK_THROWS_AS(run({50, 25, 9.82, 0, 10, 0.5}), std::invalid_argument);
  CHECK_THROWS_AS(run({50, 25, 9.82, 0.01, 0, 0.5}), std::invalid_argument);
  CHECK_THROWS_AS(run({-1e308, 25, 9.82, 10, 10, 0.5}), std::invalid_argument);
  CHECK_THROWS_WITH(run({50, 25, 9.82, 0.01, 10, 1.5}),
                    "bounce's restitution 1.5: must be finite and from 0 to 1");
}
