#include "first_contact/pairs/first_contacts.hpp"

#include "catch.hpp"
#include "first_contact/pairs/space_time.hpp"
#include "first_contact/sweep/sphere_sphere.hpp"

using namespace first_contact;

namespace {

Moving<Sphere> ball(const Point& center, const Vector& displacement, double radius = 1) {
  return {{center, radius}, displacement};
}

SpaceTimeBox box(const Eigen::Array4d& low, const Eigen::Array4d& high, std::size_t owner) {
  return {low, high, owner};
}

}  // namespace

TEST_CASE("Of many spheres, each pair that meets is found once, with the contact of its own sweep",
          "[first_contacts]") {
  const std::vector<Moving<Sphere>> spheres{ball({0, 0, 0}, {4, 0, 0}), ball({6, 0, 0}, {-4, 0, 0}),
                                            ball({0, 50, 0}, {0, 0, 0})};
  const auto found = first_contacts(spheres);
  REQUIRE(found.size() == 1);
  CHECK(found[0].first == 0);
  CHECK(found[0].second == 1);
  const auto contact = sweep(spheres[0], spheres[1]);
  CHECK(found[0].contact.time == contact->time);
  CHECK(found[0].contact.normal == contact->normal);
  CHECK(found[0].contact.point() == contact->point());
}

TEST_CASE("Contacts come in the order of their times, and of equal times, of the spheres' numbers",
          "[first_contacts]") {
  const std::vector<Moving<Sphere>> row{ball({0, 0, 0}, {0, 0, 0}),  ball({4, 0, 0}, {-4, 0, 0}),
                                        ball({0, 0, 20}, {0, 0, 0}), ball({8, 0, 20}, {-8, 0, 0}),
                                        ball({0, 40, 0}, {0, 0, 0}), ball({4, 40, 0}, {-4, 0, 0})};
  const auto found = first_contacts(row);
  REQUIRE(found.size() == 3);
  CHECK(found[0].first == 0);  // at 1/2
  CHECK(found[1].first == 4);  // at 1/2
  CHECK(found[2].first == 2);  // at 3/4
}

TEST_CASE("The earliest contact is the first of all", "[first_contacts]") {
  const std::vector<Moving<Sphere>> spheres{ball({0, 0, 0}, {8, 0, 0}), ball({10, 0, 0}, {0, 0, 0}),
                                            ball({3, 0, 0}, {0, 0, 0})};
  const auto earliest = earliest_contact(spheres);
  REQUIRE(earliest);
  CHECK(earliest->second == 2);
  CHECK(earliest->contact.time == first_contacts(spheres)[0].contact.time);
}

TEST_CASE("No spheres, one sphere, or spheres that rest have no contacts", "[first_contacts]") {
  CHECK(first_contacts({}).empty());
  CHECK_FALSE(earliest_contact({}));
  const std::vector<Moving<Sphere>> one{ball({0, 0, 0}, {1, 0, 0})};
  CHECK(first_contacts(one).empty());
  const std::vector<Moving<Sphere>> heap(20, ball({0, 0, 0}, {0, 0, 0}));
  CHECK(first_contacts(heap).empty());
}

TEST_CASE("A contact at the very beginning, at the very end and at the seam of two pieces is found once",
          "[first_contacts]") {
  // The mover is fast: its motion is cut in two at 1/2, in four at 1/4, and so on.
  const double time = GENERATE(0.0, 0.25, 0.5, 0.75, 1.0);
  std::vector<Moving<Sphere>> spheres{ball({0, 0, 0}, {64, 0, 0}), ball({64 * time + 2, 0, 0}, {0, 0, 0})};
  for (int i = 0; i < 62; ++i) spheres.push_back(ball({i % 8 * 2.5, 10.0 + i / 8 * 2.5, 30}, {0, 0, 0}));
  PairStatistics counted;
  const auto found = first_contacts(spheres, &counted);
  CHECK(counted.pieces > spheres.size());
  REQUIRE(found.size() == 1);
  CHECK(found[0].contact.time == time);
}

TEST_CASE("Boxes that share only their boundary do not overlap, boxes at different times do not either",
          "[first_contacts]") {
  const SpaceTimeBox unit = box({0, 0, 0, 0}, {1, 1, 1, 1}, 0);
  CHECK(overlap(unit, box({0.5, 0.5, 0.5, 0.5}, {2, 2, 2, 2}, 1)));
  CHECK_FALSE(overlap(unit, box({1, 0, 0, 0}, {2, 1, 1, 1}, 1)));
  CHECK_FALSE(overlap(unit, box({0, 0, 0, 1}, {1, 1, 1, 2}, 1)));
}

TEST_CASE("Without structure to use, every pair of boxes is shown once: all may overlap all",
          "[first_contacts]") {
  const std::size_t count = 200;
  std::vector<SpaceTimeBox> boxes;
  for (std::size_t i = 0; i < count; ++i) boxes.push_back(box({0, 0, 0, 0}, {1, 1, 1, 1}, i));
  std::vector<int> times(count * count);
  show_overlaps(boxes, [&](const SpaceTimeBox& a, const SpaceTimeBox& b) {
    ++times[std::min(a.owner, b.owner) * count + std::max(a.owner, b.owner)];
  });
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < count; ++j) REQUIRE(times[i * count + j] == (i < j ? 1 : 0));
}
