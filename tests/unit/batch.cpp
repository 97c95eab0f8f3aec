#include "first_contact/batch/batch.hpp"

#include <algorithm>
#include <random>

#include "catch.hpp"
#include "chance.hpp"
#include "every_processor.hpp"
#include "first_contact/sweep/box_plane.hpp"
#include "first_contact/sweep/sphere_plane.hpp"
#include "first_contact/sweep/sphere_sphere.hpp"
#include "moving_columns.hpp"

using namespace first_contact;

namespace {

using Balls = std::vector<Moving<Sphere>>;
using Boxes = std::vector<Moving<Box>>;

template <class Moving, class Obstacle>
double plain_time(const Moving& moving, const Obstacle& obstacle) {
  const auto contact = sweep(moving, obstacle);
  return contact ? contact->time : no_contact;
}

/// Whole numbers now and then, for what is equal, at rest, concentric, tangent or parallel.
class Bodies : Chance {
 public:
  using Chance::Chance;

  Vector vector(double size) {
    Vector v = Chance::vector(size);
    for (double& x : v)
      if (uniform(0, 1) < 0.4) x = std::round(x / size * 2);
    return v;
  }
  Moving<Sphere> ball(double away = 4, double speed = 6) {
    const double radius = uniform(0, 1);
    return {{vector(away), radius < 0.3 ? std::round(4 * radius) : radius}, vector(speed)};
  }
  Moving<Box> box() {
    const Vector n = Vector(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)).normalized();
    const Eigen::Matrix3d turn = uniform(0, 1) < 0.3 ? Eigen::Matrix3d(Eigen::Matrix3d::Identity())
                                                     : Eigen::AngleAxisd(uniform(0, 6), n).toRotationMatrix();
    return {
        {vector(4), uniform(0, 2) * turn.col(0), uniform(0, 2) * turn.col(1), uniform(-1, 2) * turn.col(2)},
        vector(6)};
  }
  Plane plane() {
    Vector n = vector(1);
    if (n.isZero(0)) n.z() = 1;
    return Plane(n, std::round(uniform(-2, 2)));
  }
};

/// Room for times, between numbers that nobody may write: a line of the memory before and two behind.
class Results {
 public:
  explicit Results(std::size_t count) : numbers_(count + 24, untouched) {}

  std::span<double> times() { return std::span(numbers_).subspan(8, numbers_.size() - 24); }
  bool is_all_else_untouched() const {
    const auto is_untouched = [](double number) { return number == untouched; };
    return std::all_of(numbers_.begin(), numbers_.begin() + 8, is_untouched) &&
           std::all_of(numbers_.end() - 16, numbers_.end(), is_untouched);
  }

 private:
  static constexpr double untouched = -1;

  std::vector<double> numbers_;
};

/// Sweeps them against it, and compares with the plain sweeps one by one.
template <class Many, class Obstacle, class PlainTime>
void check_times(const Many& all, const Obstacle& obstacle, const PlainTime& plain) {
  Results results(all.size());
  sweep(all, obstacle, results.times());
  for (std::size_t i = 0; i < all.size(); ++i) REQUIRE(results.times()[i] == plain(i));
  CHECK(results.is_all_else_untouched());
}

template <class Body>
std::vector<Body> first(std::size_t count, const std::vector<Body>& all) {
  return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)};
}

constexpr std::size_t many = 20003;  // not a multiple of a line of the memory

Balls balls(unsigned seed, double away = 4, double speed = 6) {
  Bodies bodies(seed);
  Balls all;
  for (std::size_t i = 0; i < many; ++i) all.push_back(bodies.ball(away, speed));
  return all;
}

Boxes boxes(unsigned seed) {
  Bodies bodies(seed);
  Boxes all;
  for (std::size_t i = 0; i < many; ++i) all.push_back(bodies.box());
  return all;
}

}  // namespace

TEST_CASE("A batch of two moving spheres has the times of the plain sweep, bit for bit", "[batch]") {
  const double speed = GENERATE(6.0, 0.5, 1e3);
  const double away = GENERATE(0.5, 4.0, 1e3);
  const Balls p = balls(1, away, speed), q = balls(2, away, speed);
  const MovingColumns p_columns(p), q_columns(q);
  std::vector<double> times(many);
  sweep(p_columns.spheres(), q_columns.spheres(), times);
  std::size_t unlike = 0, found = 0, at_once = 0;
  for (std::size_t i = 0; i < many; ++i) {
    unlike += times[i] != plain_time(p[i], q[i]);
    found += times[i] <= 1;
    at_once += times[i] == 0;
  }
  CHECK(unlike == 0);
  if (away < 1e3) CHECK(found > 500);
  if (away < 1) CHECK(at_once > 100);
}

TEST_CASE("A batch of spheres against a plane has the times of the plain sweep, bit for bit", "[batch]") {
  const Balls all = balls(3);
  const MovingColumns columns(all);
  Bodies bodies(4);
  std::vector<double> times(many);
  std::size_t unlike = 0, found = 0;
  for (int k = 0; k < 20; ++k) {
    const Plane plane = bodies.plane();
    sweep(columns.spheres(), plane, times);
    for (std::size_t i = 0; i < many; ++i)
      unlike += times[i] != plain_time(all[i], plane), found += times[i] <= 1;
  }
  CHECK(unlike == 0);
  CHECK(found > 10000);
}

TEST_CASE("A batch of boxes against a plane has the times of the plain sweep, bit for bit", "[batch]") {
  const Boxes all = boxes(5);
  Bodies bodies(13);
  const MovingColumns columns(all);
  std::vector<double> times(many);
  std::size_t unlike = 0, found = 0;
  for (int k = 0; k < 20; ++k) {
    const Plane plane = bodies.plane();
    sweep(columns.boxes(), plane, times);
    for (std::size_t i = 0; i < many; ++i)
      unlike += times[i] != plain_time(all[i], plane), found += times[i] <= 1;
  }
  CHECK(unlike == 0);
  CHECK(found > 10000);
}

TEST_CASE("A batch gives the same times on every kind of processor, whatever its length", "[batch]") {
  const std::size_t count = GENERATE(as<std::size_t>{}, 0, 1, 2, 3, 4, 5, 7, 8, 9, 15, 16, 17, 63, 64, 65, 71,
                                     72, 73, 127, 128, 129, 1000, 4096, 4097, 8200);
  const Balls p = first(count, balls(6, 1)), q = first(count, balls(7, 1));
  const Boxes all_boxes = first(count, boxes(14));
  const MovingColumns p_columns(p), q_columns(q), box_columns(all_boxes);
  const Plane plane({1, 2, 2}, 1);
  on_every_processor([&](const std::string& kind) {
    CAPTURE(kind, count);
    check_times(p_columns.spheres(), q_columns.spheres(),
                [&](std::size_t i) { return plain_time(p[i], q[i]); });
    check_times(p_columns.spheres(), plane, [&](std::size_t i) { return plain_time(p[i], plane); });
    check_times(box_columns.boxes(), plane, [&](std::size_t i) { return plain_time(all_boxes[i], plane); });
  });
}

TEST_CASE("A batch gives the same times wherever its columns begin in a page of the memory", "[batch]") {
  const std::size_t step = GENERATE(as<std::size_t>{}, 0, 1, 8, 36, 512);  // doubles; a page holds 512
  const std::size_t count = GENERATE(as<std::size_t>{}, 1000, 1003, 1007, 1015, 1023);  // whole lines, or not
  constexpr std::size_t room = 2048;
  const Balls p = first(count, balls(11, 1)), q = first(count, balls(12, 1));
  MovingColumns p_columns(p), q_columns(q);
  std::vector<double> memory(15 * (room + step), -1);
  const auto place = [&](std::size_t k) { return std::span(memory).subspan(k * (room + step), room); };
  for (std::size_t k = 0; k < 14; ++k)
    std::ranges::copy((k < 7 ? p_columns : q_columns).column(k % 7), place(k).begin());
  const auto column = [&](std::size_t k) { return std::span<const double>(place(k).first(count)); };
  const auto spheres = [&](std::size_t k) {
    return MovingSpheres({column(k), column(k + 1), column(k + 2)}, column(k + 3),
                         {column(k + 4), column(k + 5), column(k + 6)});
  };
  on_every_processor([&](const std::string& kind) {
    CAPTURE(kind, step, count);
    sweep(spheres(0), spheres(7), place(14).first(count));
    for (std::size_t i = 0; i < count; ++i) REQUIRE(place(14)[i] == plain_time(p[i], q[i]));
    CHECK(std::ranges::all_of(place(14).subspan(count), [](double number) { return number == -1; }));
  });
}

TEST_CASE("A batch keeps the contract of every sweep", "[batch]") {
  const Sphere unit{{0, 0, 0}, 1};
  const std::vector<std::pair<Moving<Sphere>, double>> cases{
      {{{{4, 0, 0}, 1}, {-4, 0, 0}}, 0.5},              // apart: the first time at which the distance is 0
      {{{{4, 0, 0}, 1}, {-2, 0, 0}}, 1},                // at the very end
      {{{{4, 0, 0}, 1}, {-1.75, 0, 0}}, no_contact},    // ends short of it
      {{{{-4, 2, 0}, 1}, {8, 0, 0}}, 0.5},              // grazing
      {{{{-4, 2.0625, 0}, 1}, {8, 0, 0}}, no_contact},  // passing
      {{{{2, 0, 0}, 1}, {-1, 0, 0}}, 0},                // touching and approaching
      {{{{2, 0, 0}, 1}, {0, 1, 0}}, no_contact},        // touching and sliding along
      {{{{2, 0, 0}, 1}, {1, 0, 0}}, no_contact},        // touching and leaving
      {{{{1, 0, 0}, 1}, {-1, 0, 0}}, 0},                // overlapping and going deeper
      {{{{1, 0, 0}, 1}, {1, 0, 0}}, no_contact},        // overlapping and leaving
      {{{{0, 0, 0}, 1}, {1, 0, 0}}, 0},                 // concentric
      {{{{0, 0, 0}, 1}, {0, 0, 0}}, no_contact},        // no motion
      {{{{4, 0, 0}, 0}, {-4, 0, 0}}, 0.75},             // a point
  };
  Balls p;
  for (const auto& [ball, time] : cases) p.push_back(ball);
  const Balls q(p.size(), Moving<Sphere>{unit, {0, 0, 0}});
  const MovingColumns p_columns(p), q_columns(q);
  std::vector<double> times(p.size());
  sweep(p_columns.spheres(), q_columns.spheres(), times);
  for (std::size_t i = 0; i < p.size(); ++i) {
    CAPTURE(i);
    CHECK(times[i] == cases[i].second);
  }
}

TEST_CASE("A batch scaled by a power of two gives the same times", "[batch]") {
  const double scale = GENERATE(0x1p-200, 0x1p-20, 0x1p20, 0x1p200);
  const auto scaled = [&](Balls all) {
    for (auto& ball : all)
      ball = {{ball.shape.center * scale, ball.shape.radius * scale}, ball.displacement * scale};
    return all;
  };
  const Balls p = balls(8), q = balls(9);
  std::vector<double> times(many), again(many);
  sweep(MovingColumns(p).spheres(), MovingColumns(q).spheres(), times);
  sweep(MovingColumns(scaled(p)).spheres(), MovingColumns(scaled(q)).spheres(), again);
  CHECK(times == again);
}

TEST_CASE("A batch's shapes are those that stand in its columns", "[batch]") {
  const Balls all = balls(10);
  const MovingColumns columns(all);
  const MovingSpheres spheres = columns.spheres();
  REQUIRE(spheres.size() == many);
  CHECK(spheres[17].shape.center == all[17].shape.center);
  CHECK(spheres[17].shape.radius == all[17].shape.radius);
  CHECK(spheres[17].displacement == all[17].displacement);
  const Moving<Box> box{{{1, 2, 3}, {2, 0, 0}, {0, 3, 0}, {0, 0, 4}}, {5, 6, 7}};
  const MovingColumns box_columns(Boxes{box});
  CHECK(box_columns.boxes()[0].shape.t == Vector(0, 0, 4));
  CHECK(box_columns.boxes()[0].displacement == Vector(5, 6, 7));
}

TEST_CASE("Columns of unequal length are refused", "[batch]") {
  const MovingColumns one(Balls(1, Moving<Sphere>{{{0, 0, 0}, 1}, {1, 0, 0}})),
      two(Balls(2, Moving<Sphere>{{{0, 0, 0}, 1}, {1, 0, 0}}));
  std::vector<double> times(2);
  CHECK_THROWS_WITH(MovingSpheres(two.at(0), one.spheres().radius(), two.at(4)),
                    ContainsSubstring("of length 2: must be of length 1"));
  CHECK_THROWS_AS(sweep(one.spheres(), two.spheres(), times), std::invalid_argument);
  CHECK_THROWS_AS(sweep(one.spheres(), one.spheres(), times), std::invalid_argument);
  CHECK_THROWS_AS(sweep(one.spheres(), Plane({0, 0, 1}, 0), times), std::invalid_argument);
}

TEST_CASE("A bad number in a column is refused when the view is made, by name", "[batch]") {
  MovingColumns columns(Balls(3, Moving<Sphere>{{{0, 0, 0}, 1}, {1, 0, 0}}));
  columns.column(3)[1] = -2;
  CHECK_THROWS_WITH(columns.spheres(), ContainsSubstring("radius -2"));
  columns.column(3)[1] = 1;
  columns.column(5)[2] = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH(columns.spheres(), ContainsSubstring("displacement"));
}

TEST_CASE("A number that becomes bad afterwards gives no contact, to its own shape alone", "[batch]") {
  const double bad =
      GENERATE(std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity());
  const std::size_t column = GENERATE(as<std::size_t>{}, 0, 1, 2, 4, 5, 6);
  MovingColumns p(Balls(8, Moving<Sphere>{{{4, 0, 0}, 1}, {-4, 0, 0}}));
  const MovingColumns q(Balls(8, Moving<Sphere>{{{0, 0, 0}, 1}, {0, 0, 0}}));
  const MovingSpheres spheres = p.spheres();
  p.column(column)[2] = bad;
  std::vector<double> times(8);
  sweep(spheres, q.spheres(), times);
  for (std::size_t i = 0; i < 8; ++i) CHECK(times[i] == (i == 2 ? no_contact : 0.5));
}
