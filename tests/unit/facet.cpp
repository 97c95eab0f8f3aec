#include "first_contact/geometry/facet.hpp"

#include "catch.hpp"

using namespace first_contact;

TEST_CASE("The unit normal of a triangle is a right-handed one, and that of a degenerate one is zero") {
  CHECK(Facet(Triangle({0, 0, 5}, {4, 0, 5}, {0, 3, 5})).unit_normal() == Vector(0, 0, 1));
  for (const Triangle& degenerate :
       {Triangle({1, 2, 3}, {1, 2, 3}, {1, 2, 3}), Triangle({0, 0, 0}, {1, 1, 1}, {3, 3, 3})}) {
    const Facet facet(degenerate);
    CHECK(facet.length == 0);
    CHECK(facet.unit_normal() == Vector(0, 0, 0));
    CHECK(facet.thin_for(0));
  }
}
