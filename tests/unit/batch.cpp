#include "first_contact/batch/batch.hpp"

#include <algorithm>
#include <random>

#include "catch.hpp"
#include "chance.hpp"
#include "first_contact/batch/batch_loops.hpp"
#include "first_contact/sweep/box_plane.hpp"
#include "first_contact/sweep/sphere_plane.hpp"
#include "first_contact/sweep/sphere_sphere.hpp"
#include "moving_columns.hpp"

using namespace first_contact;
using Catch::Matchers::Contains;

namespace {

using Balls = std::vector<Moving<Sphere>>;
using Boxes = std::vector<Moving<Box>>;

/// Those for every kind of processor that this one can stand for.
std::vector<batch::Loops> all_loops() {
  std::vector<batch::Loops> all;
  for (const batch::Loops* loops : {&batch::portable_loops, &batch::avx2_loops, &batch::avx512_loops})
    if (batch::can_run(*loops)) all.push_back(*loops);
  return all;
}

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

constexpr std::size_t many = 20003;  // not a multiple of a line of the memory

Balls balls(unsigned seed, double away = 4, double speed = 6) {
  Bodies bodies(seed);
  Balls all;
  for (std::size_t i = 0; i < many; ++i) all.push_back(bodies.ball(away, speed));
  return all;
}

}  // namespace

TEST_CASE("A batch of two moving spheres has the times of the plain sweep, bit for bit", "[batch]") {
  const double speed = GENERATE(6.0, 0.5, 1e3);
  const double away = GENERATE(0.5, 4.0, 1e3);
  const Balls p = balls(1, away, speed), q = balls(2, away, speed);
  const MovingColumns p_columns(p), q_columns(q);
  std::vector<double> times(many), portable(many);
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
  Bodies bodies(5);
  Boxes all;
  for (std::size_t i = 0; i < many; ++i) all.push_back(bodies.box());
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
  const Balls p = balls(6, 1), q = balls(7, 1);
  const std::size_t count = GENERATE(as<std::size_t>{}, 0, 1, 2, 3, 4, 5, 7, 8, 9, 15, 16, 17, 63, 64, 65, 71,
                                     72, 73, 127, 128, 129, 1000);
  const MovingColumns p_columns(Balls(p.begin(), p.begin() + static_cast<std::ptrdiff_t>(count)));
  const MovingColumns q_columns(Balls(q.begin(), q.begin() + static_cast<std::ptrdiff_t>(count)));
  const auto flat = [](const MovingSpheres& s) {
    const auto vectors = [](const Columns& c) {
      return batch::Vectors{c[0].data(), c[1].data(), c[2].data()};
    };
    return batch::Spheres{vectors(s.center()), s.radius().data(), vectors(s.displacement())};
  };
  const Plane plane({1, 2, 2}, 1);
  const batch::FlatPlane numbers{plane.normal().x(), plane.normal().y(), plane.normal().z(), plane.offset()};
  for (const batch::Loops& loops : all_loops()) {
    std::vector<double> times(count + 1, -1);  // one more than is written
    loops.sphere_sphere(flat(p_columns.spheres()), flat(q_columns.spheres()), count, times.data());
    for (std::size_t i = 0; i < count; ++i) REQUIRE(times[i] == plain_time(p[i], q[i]));
    CHECK(times[count] == -1);
    loops.sphere_plane(flat(p_columns.spheres()), numbers, count, times.data());
    for (std::size_t i = 0; i < count; ++i) REQUIRE(times[i] == plain_time(p[i], plane));
    CHECK(times[count] == -1);
  }
}

TEST_CASE("A batch gives the same times wherever its columns begin in a page of the memory", "[batch]") {
  const std::size_t step = GENERATE(as<std::size_t>{}, 0, 1, 8, 36, 512);  // doubles; a page holds 512
  const Balls p = balls(11, 1), q = balls(12, 1);
  constexpr std::size_t count = 1003, room = 2048;
  MovingColumns p_columns(Balls(p.begin(), p.begin() + count)),
      q_columns(Balls(q.begin(), q.begin() + count));
  std::vector<double> memory(15 * (room + step));
  std::array<double*, 15> columns;
  for (std::size_t k = 0; k < 15; ++k) {
    columns[k] = memory.data() + k * (room + step);
    if (k < 14) std::ranges::copy((k < 7 ? p_columns : q_columns).column(k % 7), columns[k]);
  }
  const auto spheres = [&](std::size_t k) {
    return batch::Spheres{{columns[k], columns[k + 1], columns[k + 2]},
                          columns[k + 3],
                          {columns[k + 4], columns[k + 5], columns[k + 6]}};
  };
  for (const batch::Loops& loops : all_loops()) {
    loops.sphere_sphere(spheres(0), spheres(7), count, columns[14]);
    for (std::size_t i = 0; i < count; ++i) REQUIRE(columns[14][i] == plain_time(p[i], q[i]));
  }
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
                    Contains("of length 2: must be of length 1"));
  CHECK_THROWS_AS(sweep(one.spheres(), two.spheres(), times), std::invalid_argument);
  CHECK_THROWS_AS(sweep(one.spheres(), one.spheres(), times), std::invalid_argument);
  CHECK_THROWS_AS(sweep(one.spheres(), Plane({0, 0, 1}, 0), times), std::invalid_argument);
}

TEST_CASE("A bad number in a column is refused when the view is made, by name", "[batch]") {
  MovingColumns columns(Balls(3, Moving<Sphere>{{{0, 0, 0}, 1}, {1, 0, 0}}));
  columns.column(3)[1] = -2;
  CHECK_THROWS_WITH(columns.spheres(), Contains("radius -2"));
  columns.column(3)[1] = 1;
  columns.column(5)[2] = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH(columns.spheres(), Contains("displacement"));
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
