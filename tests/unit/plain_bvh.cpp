#include "first_contact/trees/plain_bvh.hpp"

#include "catch.hpp"

using namespace first_contact;

TEST_CASE("A plain tree shows no triangle that a sphere would come to after its motion") {
  const PlainBvh floor(Mesh({{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}}, {{0, 1, 2}, {0, 2, 3}}));
  const auto shown = [&](double height) {
    int count = 0;
    floor.visit(Moving{Sphere{{0, 0, height}, 1}, Vector(0, 0, -4)}, [&](std::uint32_t) {
      ++count;
      return 2.0;
    });
    return count;
  };
  CHECK(shown(4) == 2);
  CHECK(shown(6) == 0);  // at 5/4
  CHECK(shown(8.5) == 0);
}
