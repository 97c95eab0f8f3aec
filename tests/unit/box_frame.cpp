#include "first_contact/geometry/box_frame.hpp"

#include "catch.hpp"
#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/transform.hpp"

using namespace first_contact;

namespace {

const Rigid turn = Rigid::turned({1, -2, 1}, 0.8);

/// Of a box with these sides, turned.
BoxFrame frame(const Vector& r, const Vector& s, const Vector& t) {
  return BoxFrame(turn.box({{0, 0, 0}, r, s, t}));
}

/// How far the normals are from being unit and at right angles to each other.
double crookedness(const BoxFrame& frame) {
  double worst = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      worst = std::max(worst, std::abs(dot(frame.normals[i], frame.normals[j]) - (i == j ? 1 : 0)));
  return worst;
}

}  // namespace

TEST_CASE("The frame of a box has its half lengths, and the directions of its sides") {
  const BoxFrame whole = frame({4, 0, 0}, {0, 2, 0}, {0, 0, 1});
  CHECK(crookedness(whole) < 1e-15);
  CHECK(whole.half.isApprox(Vector(2, 1, 0.5), 1e-15));
  CHECK(whole.normals[1].isApprox(turn.direction({0, 1, 0}), 1e-15));
}
TEST_CASE("A rectangle is a box without thickness, whichever of its sides is none") {
  for (const BoxFrame& flat : {frame({0, 0, 0}, {0, 2, 0}, {0, 0, 1}), frame({0, 2, 0}, {0, 0, 0}, {0, 0, 1}),
                               frame({0, 2, 0}, {0, 0, 1}, {0, 0, 0})}) {
    CHECK(crookedness(flat) < 1e-15);
    CHECK(flat.half.minCoeff() == 0);
    CHECK(flat.half.maxCoeff() == Approx(1));
    CHECK(flat.half.sum() == Approx(1.5));
    CHECK_FALSE(flat.holds(turn.direction({0, 1.001, 0})));
    CHECK_FALSE(flat.holds(turn.direction({0.001, 0, 0})));
  }
}
TEST_CASE("A rectangle along the axes holds its own points alone") {
  const BoxFrame flat(Box{{0, 0, 0}, {4, 0, 0}, {0, 2, 0}, {0, 0, 0}});
  CHECK(flat.holds({2, -1, 0}));
  CHECK_FALSE(flat.holds({2, -1, 1e-300}));
  CHECK_FALSE(flat.holds({2.001, 0, 0}));
}
TEST_CASE("A stick is a box of one side, and a box without sides is a point") {
  for (const BoxFrame& stick :
       {frame({0, 0, 0}, {0, 0, 0}, {1, 2, 3}), frame({1, 2, 3}, {0, 0, 0}, {0, 0, 0}),
        frame({0, 0, 0}, {1, 2, 3}, {0, 0, 0})}) {
    CHECK(crookedness(stick) < 1e-15);
    CHECK(stick.half.sum() == Approx(std::sqrt(14.) / 2));
  }
  const BoxFrame point = frame({0, 0, 0}, {0, 0, 0}, {0, 0, 0});
  CHECK(crookedness(point) < 1e-15);
  CHECK(point.holds({0, 0, 0}));
  CHECK_FALSE(point.holds({0, 1e-300, 0}));
}
