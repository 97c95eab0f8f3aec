#include "first_contact/sweep/sphere_sphere.hpp"

#include "catch.hpp"

using namespace first_contact;

namespace {

const Sphere unit_at_origin{{0, 0, 0}, 1};

/// A unit sphere from `start` by `displacement`, towards a unit sphere at rest at the origin: they touch at
/// distance 2.
std::optional<Contact> roll(const Point& start, const Vector& displacement) {
  return sweep(Moving<Sphere>{{start, 1}, displacement}, unit_at_origin);
}

}  // namespace

TEST_CASE("Two spheres meet when their centres are the sum of their radii apart", "[sphere_sphere]") {
  const Moving<Sphere> p{{{0, 0, 0}, 1}, {4, 0, 0}};
  const Moving<Sphere> q{{{6, 0, 0}, 0.5}, {-5, 0, 0}};
  const auto contact = sweep(p, q);
  REQUIRE(contact);
  CHECK(contact->time == 0.5);
  CHECK(contact->normal == Vector(-1, 0, 0));  // from q to p
  CHECK(contact->point() == Point(3, 0, 0));   // P(t) = (2, 0, 0), Q(t) = (3.5, 0, 0)
  CHECK(contact->feature == Feature::face);
  CHECK(contact->triangle == no_triangle);
}

TEST_CASE("The paper's two roots are the beginning of the contact and the parting", "[sphere_sphere]") {
  const Moving<Sphere> p{{{-4, 0, 0}, 1}, {2, 0, 0}};
  const auto times = contact_interval(p, {unit_at_origin, {0, 0, 0}});
  REQUIRE(times);
  CHECK(times->begin == 1);
  CHECK(times->end == 3);
}

TEST_CASE("Both roots may lie in the past, or one on each side of now", "[sphere_sphere]") {
  const auto past = contact_interval({{{6, 0, 0}, 1}, {4, 0, 0}}, {unit_at_origin, {0, 0, 0}});
  REQUIRE(past);
  CHECK(past->begin == -2);
  CHECK(past->end == -1);
  const auto now = contact_interval({{{1, 0, 0}, 1}, {1, 0, 0}}, {unit_at_origin, {0, 0, 0}});
  REQUIRE(now);
  CHECK(now->begin == -3);
  CHECK(now->end == 1);
}

TEST_CASE("At the closest approach itself, the roots are as far before as after", "[sphere_sphere]") {
  const auto times = contact_interval({{{0, 0, 0}, 1}, {4, 0, 0}}, {unit_at_origin, {0, 0, 0}});
  REQUIRE(times);
  CHECK(times->begin == -0.5);
  CHECK(times->end == 0.5);
}

TEST_CASE("Spheres of equal velocity never begin to touch and never part", "[sphere_sphere]") {
  CHECK_FALSE(contact_interval({{{5, 0, 0}, 1}, {1, 2, 3}}, {unit_at_origin, {1, 2, 3}}));
  CHECK_FALSE(contact_interval({{{1, 0, 0}, 1}, {1, 2, 3}}, {unit_at_origin, {1, 2, 3}}));
  CHECK_FALSE(sweep(Moving<Sphere>{{{1, 0, 0}, 1}, {1, 2, 3}}, Moving<Sphere>{unit_at_origin, {1, 2, 3}}));
}

TEST_CASE("Spheres that pass each other by have no contact", "[sphere_sphere]") {
  CHECK_FALSE(roll({-4, 2.0625, 0}, {8, 0, 0}));
  CHECK_FALSE(contact_interval({{{-4, 2.0625, 0}, 1}, {8, 0, 0}}, {unit_at_origin, {0, 0, 0}}));
}

TEST_CASE("Spheres that graze have a contact, and the normal is across the motion", "[sphere_sphere]") {
  const auto contact = roll({-4, 2, 0}, {8, 0, 0});
  REQUIRE(contact);
  CHECK(contact->time == 0.5);
  CHECK(contact->normal == Vector(0, 1, 0));
  CHECK(contact->point() == Point(0, 1, 0));
}

TEST_CASE("A sphere that ends short of another has no contact, one that arrives exactly has",
          "[sphere_sphere]") {
  CHECK_FALSE(roll({4, 0, 0}, {-1.75, 0, 0}));
  CHECK(roll({4, 0, 0}, {-2, 0, 0})->time == 1);
  CHECK(roll({6, 8, 0}, {-4.8, -6.4, 0})->time == 1);
}

TEST_CASE("A contact before the motion or after it does not count", "[sphere_sphere]") {
  CHECK_FALSE(roll({4, 0, 0}, {8, 0, 0}));
  CHECK_FALSE(roll({9, 0, 0}, {-4, 0, 0}));
}

TEST_CASE("Touching spheres have a contact only if they approach", "[sphere_sphere]") {
  const auto contact = roll({2, 0, 0}, {-1, 5, 0});
  REQUIRE(contact);
  CHECK(contact->time == 0);
  CHECK(contact->normal == Vector(1, 0, 0));
  CHECK_FALSE(roll({2, 0, 0}, {0, 5, 0}));
  CHECK_FALSE(roll({2, 0, 0}, {1, 5, 0}));
}

TEST_CASE("Overlapping spheres have a contact at once if they go deeper, none if they leave",
          "[sphere_sphere]") {
  const auto contact = roll({1.5, 0, 0}, {-1, 0, 0});
  REQUIRE(contact);
  CHECK(contact->time == 0);
  CHECK(contact->normal == Vector(1, 0, 0));
  CHECK(contact->point() == Point(0.5, 0, 0));  // C = P - r_P N is inside the obstacle then
  CHECK_FALSE(roll({1.5, 0, 0}, {1, 0, 0}));
  CHECK_FALSE(roll({1.5, 0, 0}, {0, 1, 0}));
}

TEST_CASE("Spheres at rest to each other have no contact, overlapping or not", "[sphere_sphere]") {
  CHECK_FALSE(roll({1.5, 0, 0}, {0, 0, 0}));
  CHECK_FALSE(roll({2, 0, 0}, {0, 0, 0}));
  CHECK_FALSE(roll({3, 0, 0}, {0, 0, 0}));
}

TEST_CASE("Concentric spheres have their normal against the motion", "[sphere_sphere]") {
  const auto contact = roll({0, 0, 0}, {0, -3, 0});
  REQUIRE(contact);
  CHECK(contact->time == 0);
  CHECK(contact->normal == Vector(0, 1, 0));
}

TEST_CASE("Spheres of radius 0 are points: they meet only head on, with the normal against the motion",
          "[sphere_sphere]") {
  const Moving<Sphere> p{{{-1, -1, 0}, 0}, {2, 2, 0}};
  const auto contact = sweep(p, Sphere{{0, 0, 0}, 0});
  REQUIRE(contact);
  CHECK(contact->time == 0.5);
  CHECK(contact->normal.isApprox(Vector(-1, -1, 0).normalized(), 1e-15));
  CHECK_FALSE(sweep(p, Sphere{{0, 0, 0.125}, 0}));
  CHECK(sweep(p, Sphere{{0, 0, 0.125}, 0.125})->time == 0.5);
}

TEST_CASE("The interval decides which contact counts, as the paper says of t_m .. t_n", "[sphere_sphere]") {
  const Moving<Sphere> p{{{-6, 0, 0}, 1}, {2, 0, 0}};
  const Moving<Sphere> q{unit_at_origin, {0, 0, 0}};
  CHECK_FALSE(sweep(p, q));
  CHECK(sweep(p, q, {1, 2})->time == 2);
  CHECK(sweep(p, q, {-10, 10})->time == 2);
  CHECK_FALSE(sweep(p, q, {-10, 1}));
  CHECK_FALSE(sweep(p, q, {5, 10}));
}

TEST_CASE("Within an interval, overlapping is judged at its first time", "[sphere_sphere]") {
  const Moving<Sphere> p{{{-6, 0, 0}, 1}, {2, 0, 0}};  // touches at 2, concentric at 3, parts at 4
  const Moving<Sphere> q{unit_at_origin, {0, 0, 0}};
  const auto deeper = sweep(p, q, {2.5, 9});
  REQUIRE(deeper);
  CHECK(deeper->time == 2.5);
  CHECK(deeper->normal == Vector(-1, 0, 0));
  CHECK(sweep(p, q, {3, 9})->normal == Vector(-1, 0, 0));  // concentric: against the motion
  CHECK_FALSE(sweep(p, q, {3.5, 9}));                      // leaving
  CHECK_FALSE(sweep(p, q, {4, 9}));                        // touching and leaving
}

TEST_CASE("An interval may be in the past, or a single instant", "[sphere_sphere]") {
  const Moving<Sphere> p{{{8, 0, 0}, 1}, {2, 0, 0}};
  const Moving<Sphere> q{unit_at_origin, {0, 0, 0}};
  const auto contact = sweep(p, q, {-6, -4});
  REQUIRE(contact);
  CHECK(contact->time == -5);
  CHECK(contact->normal == Vector(-1, 0, 0));
  CHECK(sweep(p, q, {-5, -5})->time == -5);
  CHECK_FALSE(sweep(p, q, {-6, -6}));
}

TEST_CASE("An interval that ends before it begins, or never, is refused", "[sphere_sphere]") {
  CHECK_THROWS_AS(Interval(2, 1), std::invalid_argument);
  CHECK_THROWS_AS(Interval(0, INFINITY), std::invalid_argument);
  CHECK_THROWS_AS(Interval(NAN, 1), std::invalid_argument);
}

TEST_CASE("Spheres overlap from touching on", "[sphere_sphere]") {
  CHECK(overlap(Sphere{{3, 4, 0}, 3}, Sphere{{0, 0, 0}, 2}));
  CHECK(overlap(Sphere{{3, 3, 0}, 3}, Sphere{{0, 0, 0}, 2}));
  CHECK_FALSE(overlap(Sphere{{3, 4.0625, 0}, 3}, Sphere{{0, 0, 0}, 2}));
}

TEST_CASE("Far away, the textbook root in single precision misses a hit of three fifths of the reach",
          "[sphere_sphere]") {
  const Vector3<float> u{3, 4, 0},
      w{-6007.25F, -8007, 0};  // passing at 1.6, with a reach of 2: from t = 2001.75 on
  CHECK_FALSE(textbook_times(w, u, 2.0F).has_value());
  const auto times = contact_times(w, u, 2.0F);
  REQUIRE(times);
  CHECK(times->begin == Approx(2001.75).epsilon(1e-7));
  CHECK(times->end == Approx(2002.23).epsilon(1e-7));
}

TEST_CASE("Far away, the textbook root in single precision finds a hit where there is none",
          "[sphere_sphere]") {
  const Vector3<float> u{3, 4, 0}, w{-6011.25F, -8011, 0};  // passing at 2.4, with a reach of 2
  CHECK(textbook_times(w, u, 2.0F).has_value());
  CHECK_FALSE(contact_times(w, u, 2.0F).has_value());
}

TEST_CASE("Near by, the textbook root and the stable one are the same", "[sphere_sphere]") {
  const Vector u{3, 4, 0}, w{-7.25, -7, 0};
  const auto printed = textbook_times(w, u, 2.0), stable = contact_times(w, u, 2.0);
  REQUIRE(printed);
  REQUIRE(stable);
  CHECK(printed->begin == Approx(stable->begin).epsilon(1e-14));
  CHECK(printed->end == Approx(stable->end).epsilon(1e-14));
}

TEST_CASE("The cross product of long and nearly parallel vectors is right to the last place",
          "[sphere_sphere]") {
  // (2^27 + 1, 2^27) x (2^27, 2^27 - 1): the products need 55 digits, their difference is -1.
  const double n = 134217728;
  CHECK(accurate_cross<double>({n + 1, n, 0}, {n, n - 1, 0}) == Vector(0, 0, -1));
}

// Numbers that have been got wrong in public; the sources are named, the truth was computed with 80 digits.

TEST_CASE("JOML-CI/JOML#304: overlapping far from the origin", "[sphere_sphere][published]") {
  const Sphere p{{337, 1612, 71}, 8.55963316971002}, q{{328.10107421875, 1608.3077392578125, 70.125}, 4};
  CHECK(overlap(p, q));
  CHECK_FALSE(sweep(Moving<Sphere>{p, {0, 0, 0}}, q));  // by contract: no motion
}

TEST_CASE("erincatto/box2d#625: a point a hundredth of a radius outside, moving in",
          "[sphere_sphere][published]") {
  const Point start{0.105458483, -0.229372352, 0};
  const auto contact = sweep(Moving<Sphere>{{start, 0}, -start}, Sphere{{0, 0, 0}, 0.249999985});
  REQUIRE(contact);
  CHECK(contact->time == Approx(0.00972177164750235).epsilon(1e-13));
  CHECK(contact->normal.isApprox(Vector(0.417732983903907, -0.9085698400006122, 0), 1e-15));
}

TEST_CASE("rustgd/collision-rs PR 82: a squared distance is compared with a squared sum",
          "[sphere_sphere][published]") {
  CHECK(overlap(Sphere{{0, 0, 0}, 5}, Sphere{{9, 0, 0}, 5}));
  CHECK_FALSE(overlap(Sphere{{0, 0, 0}, 5}, Sphere{{11, 0, 0}, 5}));
}

TEST_CASE("dimforge/parry PR 206: overlapping and separating is no contact", "[sphere_sphere][published]") {
  const Moving<Sphere> leaving{{{1, 1, 0}, 1}, {1, 2, 0}};
  CHECK(overlap(leaving.shape, Sphere{{0, 0, 0}, 2}));
  CHECK_FALSE(sweep(leaving, Sphere{{0, 0, 0}, 2}));
}

TEST_CASE("Spheres that are tiny beside their way touch by their offset from it, or pass each other") {
  for (const double size : {0x1p-200, 0x1p-500, 0x1p-600, 0x1p-900}) {
    CAPTURE(size);
    const auto meet = [&](double offset) {
      return sweep(Moving{Sphere{{1, offset * size, 0}, 0.5 * size}, Vector(-2, 0, 0)},
                   Sphere{{0, 0, 0}, 0.5 * size});
    };
    const auto contact = meet(0.6);
    REQUIRE(contact);
    CHECK(contact->time == Approx(0.5));
    CHECK((contact->normal - Vector(0.8, 0.6, 0)).norm() < 1e-14);
    CHECK_FALSE(meet(1.1));
  }
}
