#include "first_contact/sweep/sphere_triangle.hpp"

#include <cmath>
#include <iomanip>
#include <limits>
#include <random>
#include <sstream>

#include "catch.hpp"
#include "exact_triangle.hpp"
#include "first_contact/sweep/ray_triangle.hpp"

using namespace first_contact;

namespace {

/// A cast at a triangle, chosen so that it is likely to be a hard one.
struct Cast {
  Triangle triangle;
  Sphere sphere;
  Vector displacement;

  /// L of the bound that sphere_triangle.hpp states.
  double reach() const {
    const auto& [a, b, c] = triangle;
    const double corner =
        std::max({(sphere.center - a).norm(), (sphere.center - b).norm(), (sphere.center - c).norm()});
    return corner + std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()}) + displacement.norm() +
           sphere.radius;
  }
  std::string text() const {
    std::ostringstream out;
    out << std::hexfloat;
    for (const Vector& v : {triangle.a, triangle.b, triangle.c, sphere.center, displacement})
      out << "{" << v.x() << ", " << v.y() << ", " << v.z() << "}, ";
    out << "radius " << sphere.radius;
    return out.str();
  }
};

class Caster {
 public:
  explicit Caster(std::uint64_t seed) : random_(seed) {}

  double uniform(double from, double to) { return std::uniform_real_distribution<>(from, to)(random_); }
  int pick(int n) { return std::uniform_int_distribution<>(0, n - 1)(random_); }
  Vector direction() {
    std::normal_distribution<> normal;
    return Vector{normal(random_), normal(random_), normal(random_)}.normalized();
  }

  /// Well shaped, a needle, a cap, a segment, or a point.
  Triangle triangle() {
    const Point a = direction(), b = direction(), c = direction();
    const double thin = std::pow(10, uniform(-14, -1));
    switch (pick(8)) {
      case 0:
        return {a, b, a + thin * (c - a)};
      case 1:
        return {a, b, a + uniform(0.1, 0.9) * (b - a) + thin * c};
      case 2:
        return {a, b, a + uniform(-0.5, 1.5) * (b - a)};
      case 3:
        return pick(4) == 0 ? Triangle{a, a, a} : Triangle{a, b, a};
      default:
        return {a, b, c};
    }
  }

  /// A sphere that would touch the inside, an edge or a vertex, or the seam between two of them, squarely or
  /// barely.
  Cast cast(double scale, const Vector& shift) {
    const Triangle t = triangle();
    const double radius = pick(8) == 0 ? 0 : std::pow(10, uniform(-3, 1));
    const double u = uniform(0, 1), v = uniform(0, 1 - u);
    const Point edge_point = t.a + u * (t.b - t.a);
    const Point target = std::array<Point, 3>{Point(t.a + u * (t.b - t.a) + v * (t.c - t.a)), edge_point,
                                              t.a}[static_cast<std::size_t>(pick(3))];
    const Vector flat = t.area_vector();
    const Vector away = pick(2) == 0 && flat.norm() > 0 ? Vector(flat.normalized()) : direction();
    const Point touching = target + radius * away;
    const Vector along = away.cross(direction());
    const double slope = std::array<double, 3>{1, 1e-4, 0}[static_cast<std::size_t>(pick(3))] * uniform(0, 1);
    const Vector displacement = uniform(0.1, 4) * (along - slope * away);
    const Point start =
        touching - uniform(0, 1.1) * displacement + std::pow(10, uniform(-18, -1)) * direction();
    const auto put = [&](const Point& p) { return Point(scale * p + shift); };
    return {{put(t.a), put(t.b), put(t.c)}, {put(start), scale * radius}, scale * displacement};
  }

 private:
  std::mt19937_64 random_;
};

void check_bound(const Cast& cast, const std::optional<Contact>& contact) {
  const double r = cast.sphere.radius;
  const double bound = 16 * std::numeric_limits<double>::epsilon() * cast.reach();
  const oracle::Approach approach(cast.triangle, cast.sphere.center, cast.displacement);
  if (approach.distance(oracle::Real(0)) <= r + bound)
    return;  // touching at the start: judged by its own tests

  const auto earliest = approach.first_time(oracle::Real(r) + bound);
  const auto latest = approach.first_time(oracle::Real(r) - bound);
  if (latest) REQUIRE(contact);  // never a miss
  if (!contact) return;
  REQUIRE(earliest);  // never an invention
  constexpr double rounding_of_t = std::numeric_limits<double>::epsilon();
  CHECK(contact->time >= static_cast<double>(*earliest) * (1 - rounding_of_t));
  if (latest) CHECK(contact->time <= static_cast<double>(*latest) * (1 + rounding_of_t));
}

void check_casts(std::uint64_t seed, int count, double scale, const Vector& shift) {
  Caster caster(seed);
  int hits = 0;
  for (int i = 0; i < count; ++i) {
    const Cast cast = caster.cast(scale, shift);
    INFO("seed " << seed << ", cast " << i << ": " << cast.text());
    const auto contact = sweep(Moving<Sphere>{cast.sphere, cast.displacement}, cast.triangle);
    check_bound(cast, contact);
    hits += contact.has_value();
    if (cast.sphere.radius == 0)
      check_bound(cast, sweep(Moving<Point>{cast.sphere.center, cast.displacement}, cast.triangle));
  }
  CHECK(hits > count / 4);  // the casts are aimed well enough to mean something
}

}  // namespace

TEST_CASE("The time of a sphere and a triangle is exact for a radius within 16 eps of the scene") {
  check_casts(1, 2000, 1, {0, 0, 0});
}
TEST_CASE("The bound holds far from the origin, where only differences count") {
  check_casts(2, 700, 1, {1e6, -3e5, 2e6});
}
TEST_CASE("The bound holds for a tiny scene and for a huge one") {
  check_casts(3, 400, 1e-24, {0, 0, 0});
  check_casts(4, 400, 1e24, {0, 0, 0});
}
