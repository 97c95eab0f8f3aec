// What the essays claim of rounding and of costs, and show by a measurement of their own.
#include "04_general_sphere/seam.hpp"
#include "06_moving_spheres/nearly_touching.hpp"
#include "catch.hpp"
#include "first_contact/program/counted.hpp"
#include "first_contact/sweep/contact_times.hpp"

using namespace first_contact;
using program::Counted;

TEST_CASE("At a flat seam no point slips between two faces, but balls do, and the edge stops them") {
  const auto points = general_sphere_chapter::shots_at_a_seam(0);
  CHECK(points.both_faces_missed == 0);
  const auto balls = general_sphere_chapter::shots_at_a_seam(1);
  CHECK(balls.both_faces_missed > balls.balls / 100);
  CHECK(balls.missed == 0);
}

TEST_CASE(
    "When spheres nearly touch, the product of the roots is better by a factor, and both ways err as one "
    "over the gap") {
  const NearErrors near = nearly_touching(1e-3), nearer = nearly_touching(1e-4);
  CHECK(near.by_product < near.by_difference);
  CHECK(nearer.by_product / near.by_product == Approx(10).epsilon(0.5));
  CHECK(nearer.by_difference / near.by_difference == Approx(10).epsilon(0.5));
}

TEST_CASE(
    "By the product of the roots, spheres that are found apart and meet have their contact in the future") {
  for (int i = 1; i < 1000; ++i) {
    const Vector3<float> w(1 + 1e-7F * static_cast<float>(i), 1e-3F, 0),
        u(-1, 0.1F * static_cast<float>(i % 7), 0);
    const auto times = contact_times(w, u, 1.0F);
    if (w.squaredNorm() > 1 && times) CHECK(times->begin > 0);
  }
}

TEST_CASE("A number that counts computes as a double does, and counts each operation once") {
  const Vector3<Counted> w(-3, 1, 0), u(2, 0, 1);
  std::optional<ContactTimes<Counted>> times;
  const program::Operations done = Counted::in([&] { times = contact_times<Counted>(w, u, 2); });
  const auto plain = contact_times<double>({-3, 1, 0}, {2, 0, 1}, 2);
  CHECK(times->begin.value() == plain->begin);
  CHECK(times->end.value() == plain->end);
  CHECK(done.divisions == 2);
  CHECK(done.roots == 1);
  CHECK(Counted::in([&] { return w.dot(u); }).multiplications == 3);
  CHECK(Counted::in([&] { return w.dot(u); }).additions == 2);
}
