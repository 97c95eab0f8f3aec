// Moving spheres against the paper's own formula, evaluated with 50 digits on the very doubles that the
// library gets, and against dense sampling of the distance.

#include "first_contact/sweep/sphere_sphere.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>

#include "catch.hpp"

using namespace first_contact;
using Real = boost::multiprecision::cpp_bin_float_50;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double factor = 8;  // of the error bounds that sphere_sphere.hpp states

struct Exact {
  bool meets = false;
  Real begin, end;
  Real distance, speed, reach, half_chord;  // |w|, |u|, d, h
  Real miss;                                // distance at the closest approach
};

Real dot(const std::array<Real, 3>& a, const std::array<Real, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

std::array<Real, 3> difference(const Vector& a, const Vector& b) {
  return {Real(a.x()) - Real(b.x()), Real(a.y()) - Real(b.y()), Real(a.z()) - Real(b.z())};
}

Exact exact(const Moving<Sphere>& p, const Moving<Sphere>& q) {
  const auto w = difference(p.shape.center, q.shape.center), u = difference(p.displacement, q.displacement);
  const Real d = Real(p.shape.radius) + Real(q.shape.radius);
  const Real a = dot(u, u), b = dot(w, u), c = dot(w, w) - d * d, D = b * b - a * c;
  Exact result;
  result.distance = sqrt(dot(w, w));
  result.speed = sqrt(a);
  result.reach = d;
  result.miss = sqrt(abs(dot(w, w) - b * b / a));
  result.meets = D >= 0;
  if (!result.meets) return result;
  result.half_chord = sqrt(D / a);
  result.begin = (-b - sqrt(D)) / a;
  result.end = (-b + sqrt(D)) / a;
  return result;
}

/// The stated bound on the error of each time; without a chord there is none.
Real bound(const Exact& truth) {
  return factor * eps * (truth.distance + truth.reach * truth.reach / truth.half_chord) / truth.speed;
}

Vector unit_vector(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Vector(normal(random), normal(random), normal(random)).normalized();
}

double uniform(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

struct Pair {
  Moving<Sphere> p, q;
};

/// Two spheres whose distance at the closest approach is about `miss` times the sum of their radii, after a
/// way of `away` such sums; all lengths times `scale`, and the relative speed `speed`.
Pair aimed(std::mt19937& random, double miss, double away, double scale, double speed) {
  const double rp = scale * uniform(random, 0, 1), rq = scale * uniform(random, 0, 1);
  const Vector direction = unit_vector(random), across = direction.cross(unit_vector(random)).normalized();
  const Vector w = (rp + rq) * (miss * across - away * direction);
  const Point q = scale * 3 * unit_vector(random);
  const Vector common = speed * uniform(random, 0, 2) * unit_vector(random);
  return {{{q + w, rp}, common + speed * direction}, {{q, rq}, common}};
}

/// Checks one pair; the largest error, in units of the bound, is kept in `worst`.
void check(const Pair& pair, double& worst) {
  const Exact truth = exact(pair.p, pair.q);
  const auto times = contact_interval(pair.p, pair.q);
  if (truth.miss < truth.reach * (1 - factor * eps)) REQUIRE(times);
  if (truth.miss > truth.reach * (1 + factor * eps)) REQUIRE_FALSE(times);
  if (!times || !truth.meets || truth.half_chord == 0) return;
  REQUIRE(times->begin <= times->end);
  for (const Real& error : {Real(abs(times->begin - truth.begin)), Real(abs(times->end - truth.end))}) {
    worst = std::max(worst, static_cast<double>(error / bound(truth)));
    REQUIRE(error <= bound(truth));
  }
}

/// `count` random pairs with what `make` makes of a generator.
template <class Make>
void check_all(int count, unsigned seed, Make make) {
  CAPTURE(seed);
  std::mt19937 random(seed);
  double worst = 0;
  for (int i = 0; i < count; ++i) {
    CAPTURE(i);
    check(make(random), worst);
  }
  UNSCOPED_INFO("worst error: " << worst << " of the bound");
  CHECK(worst < 1);
}

}  // namespace

TEST_CASE("Spheres near each other: both times are within the bound", "[oracle][sphere_sphere]") {
  check_all(20000, 1,
            [](auto& r) { return aimed(r, uniform(r, 0, 1.5), uniform(r, -5, 5), 1, uniform(r, 0.1, 10)); });
}

TEST_CASE("Spheres from as far as 10^12 radii: both times are within the bound", "[oracle][sphere_sphere]") {
  check_all(20000, 2, [](auto& r) {
    return aimed(r, uniform(r, 0, 1.2), std::pow(10, uniform(r, 0, 12)), 1, uniform(r, 0.1, 10));
  });
}

TEST_CASE("Spheres at any speed: both times are within the bound", "[oracle][sphere_sphere]") {
  check_all(20000, 3, [](auto& r) {
    return aimed(r, uniform(r, 0, 1.2), uniform(r, -9, 9), 1, std::pow(10, uniform(r, -30, 30)));
  });
}

TEST_CASE("Spheres of any size: both times are within the bound", "[oracle][sphere_sphere]") {
  check_all(20000, 4, [](auto& r) {
    const double scale = std::pow(10, uniform(r, -50, 50));
    return aimed(r, uniform(r, 0, 1.2), uniform(r, -9, 9), scale, scale * uniform(r, 0.1, 10));
  });
}

TEST_CASE("Grazing spheres, near and far: found or not, the times are within the bound",
          "[oracle][sphere_sphere]") {
  check_all(40000, 5, [](auto& r) {
    const double depth = std::copysign(std::pow(10, uniform(r, -17, -1)), uniform(r, -1, 3));
    return aimed(r, 1 - depth, std::pow(10, uniform(r, 0, 7)), 1, 1);
  });
}

TEST_CASE("Spheres that start with next to no gap: both times are within the bound",
          "[oracle][sphere_sphere]") {
  check_all(20000, 6, [](auto& r) {
    const double miss = uniform(r, 0, 1), gap = std::pow(10, uniform(r, -16, -3));
    return aimed(r, miss, std::sqrt((1 + gap - miss) * (1 + gap + miss)), 1, 1);
  });
}

TEST_CASE("The sweep over any interval agrees with 50 digits, within its bound", "[oracle][sphere_sphere]") {
  const unsigned seed = 7;
  CAPTURE(seed);
  std::mt19937 random(seed);
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    CAPTURE(i);
    const Pair pair = aimed(random, uniform(random, 0, 1.1), uniform(random, -1e3, 1e3), 1, 1);
    const double first = uniform(random, -3e3, 3e3), last = first + uniform(random, 0, 3e3);
    const Exact truth = exact(pair.p, pair.q);
    if (!truth.meets || truth.half_chord == 0) continue;
    // |w| at t_m; and half a unit in the last place of t
    const Real start = abs(first - (truth.begin + truth.end) / 2) * truth.speed + truth.reach;
    const Real error =
        factor * eps * (start + truth.reach * truth.reach / truth.half_chord) / truth.speed + eps * 6e3;
    const auto contact = sweep(pair.p, pair.q, {first, last});
    const Real middle = (truth.begin + truth.end) / 2;
    if (truth.begin < first && middle < first) {  // leaving, or gone
      if (middle < first - error) REQUIRE_FALSE(contact);
    } else if (truth.begin < first - error && middle > first + error) {  // going deeper
      REQUIRE(contact);
      REQUIRE(contact->time == first);
      ++hits;
    } else if (truth.begin > first + error && truth.begin < last - error) {
      REQUIRE(contact);
      REQUIRE(abs(contact->time - truth.begin) <= error);
      ++hits;
    } else if (truth.begin > last + error) {
      REQUIRE_FALSE(contact);
    }
  }
  CHECK(hits > 2000);
}

TEST_CASE(
    "The normal is right to a few units of the last place however far the spheres come from, unless they "
    "graze",
    "[oracle][sphere_sphere]") {
  const unsigned seed = 8;
  CAPTURE(seed);
  std::mt19937 random(seed);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    CAPTURE(i);
    const Pair pair = aimed(random, uniform(random, 0, 0.999), std::pow(10, uniform(random, 0, 12)), 1, 1);
    const auto contact = sweep(pair.p, pair.q, {0, 1e300});
    const Exact truth = exact(pair.p, pair.q);
    if (truth.begin <= 0) continue;
    REQUIRE(contact);
    const auto w = difference(pair.p.shape.center, pair.q.shape.center);
    const auto u = difference(pair.p.displacement, pair.q.displacement);
    Real error = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Real n = (w[k] + truth.begin * u[k]) / truth.reach;
      error = std::max<Real>(error, abs(n - contact->normal[static_cast<int>(k)]));
    }
    worst = std::max(worst, static_cast<double>(error * truth.half_chord / truth.reach));
  }
  CAPTURE(worst / eps);
  CHECK(worst <= 4 * eps);  // times d / h
}

TEST_CASE("A power of two scales the times exactly, in lengths and in speeds", "[oracle][sphere_sphere]") {
  const unsigned seed = 9;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 5000; ++i) {
    CAPTURE(i);
    const Pair pair =
        aimed(random, uniform(random, 0, 1.1), uniform(random, 1, 9), 1, uniform(random, 1, 20));
    const int length = static_cast<int>(uniform(random, -200, 200)),
              speed = static_cast<int>(uniform(random, -200, 200));
    const auto scaled = [&](const Moving<Sphere>& s) {
      return Moving<Sphere>{{s.shape.center * std::ldexp(1, length), std::ldexp(s.shape.radius, length)},
                            s.displacement * std::ldexp(1, speed)};
    };
    const auto times = contact_interval(pair.p, pair.q),
               again = contact_interval(scaled(pair.p), scaled(pair.q));
    REQUIRE(times.has_value() == again.has_value());
    if (!times) continue;
    REQUIRE(again->begin == std::ldexp(times->begin, length - speed));
    REQUIRE(again->end == std::ldexp(times->end, length - speed));
    const auto contact = sweep(pair.p, pair.q, {0, 1e3});
    const auto large = sweep(scaled(pair.p), scaled(pair.q), {0, std::ldexp(1e3, length - speed)});
    REQUIRE(contact.has_value() == large.has_value());
    if (!contact) continue;
    REQUIRE(large->normal == contact->normal);
    REQUIRE(large->point() == contact->point() * std::ldexp(1, length));
  }
}

TEST_CASE("Dense sampling and bisection of the distance find the same first contact",
          "[oracle][sphere_sphere]") {
  const unsigned seed = 10;
  CAPTURE(seed);
  std::mt19937 random(seed);
  constexpr int samples = 4000;
  int hits = 0;
  for (int i = 0; i < 500; ++i) {
    CAPTURE(i);
    const Pair pair =
        aimed(random, uniform(random, 0, 1.2), uniform(random, 1.2, 6), 1, uniform(random, 1, 10));
    const auto gap = [&](double t) {
      const Vector p = pair.p.shape.center + t * pair.p.displacement,
                   q = pair.q.shape.center + t * pair.q.displacement;
      return (p - q).norm() - (pair.p.shape.radius + pair.q.shape.radius);
    };
    int k = 0;
    while (k <= samples && gap(double(k) / samples) > 0) ++k;
    const auto contact = sweep(pair.p, pair.q);
    const Exact truth = exact(pair.p, pair.q);
    if (k > samples) {  // no sample touches: at most a graze between two of them
      if (contact) REQUIRE(truth.end - truth.begin < 1.0 / samples);
      continue;
    }
    if (k == 0) continue;
    double apart = double(k - 1) / samples, touching = double(k) / samples;
    for (int step = 0; step < 60; ++step) {
      const double middle = (apart + touching) / 2;
      (gap(middle) > 0 ? apart : touching) = middle;
    }
    REQUIRE(contact);
    REQUIRE(contact->time == Approx(touching).margin(1e-9));
    ++hits;
  }
  CHECK(hits > 100);
}
