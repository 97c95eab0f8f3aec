// A batch of moving spheres against 50 digits.

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <random>

#include "catch.hpp"
#include "moving_columns.hpp"

using namespace first_contact;
using Real = boost::multiprecision::cpp_bin_float_50;

namespace {

struct Truth {
  Real time;
  Real depth;  ///< how far P goes inside, as a share of d: h^2 / d^2
};

std::optional<Truth> truth(const Moving<Sphere>& p, const Moving<Sphere>& q) {
  Real a = 0, b = 0, ww = 0;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Real w = Real(p.shape.center[k]) - Real(q.shape.center[k]),
               u = Real(p.displacement[k]) - Real(q.displacement[k]);
    a += u * u;
    b += w * u;
    ww += w * w;
  }
  const Real d = Real(p.shape.radius) + Real(q.shape.radius);
  const Real D = b * b - a * (ww - d * d);
  if (D < 0 || ww <= d * d || b >= 0) return std::nullopt;
  return Truth{(-b - sqrt(D)) / a, D / (a * d * d)};
}

}  // namespace

TEST_CASE("The times of a batch are right to 4e-15, unless the spheres graze", "[oracle][batch]") {
  const unsigned seed = 20;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto vector = [&](double size) {
    return Vector(size * uniform(random), size * uniform(random), size * uniform(random));
  };
  std::vector<Moving<Sphere>> p, q;
  for (int i = 0; i < 100000; ++i) {
    p.push_back({{vector(3), 0.5 + 0.5 * uniform(random)}, vector(4)});
    q.push_back({{vector(3), 0.5 + 0.5 * uniform(random)}, vector(4)});
  }
  std::vector<double> times(p.size());
  sweep(MovingColumns(p).spheres(), MovingColumns(q).spheres(), times);
  double worst = 0;
  std::size_t hits = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    CAPTURE(i);
    const auto exact = truth(p[i], q[i]);
    if (!exact || exact->depth < 1e-4) continue;
    if (abs(exact->time - 1) < 4e-15) continue;
    REQUIRE((times[i] <= 1) == (exact->time <= 1));
    if (times[i] > 1) continue;
    worst = std::max(worst, static_cast<double>(abs(times[i] - exact->time)));
    ++hits;
  }
  CHECK(hits > 2000);
  CHECK(worst * 1e15 < 4);
}
