#include "first_contact/stage/hit_test.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "catch.hpp"

using namespace first_contact;

namespace {

const std::vector<Point2> triangle{{0, 0}, {4, 0}, {0, 4}};
const std::vector<Point2> letter_l{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
const std::vector<Point2> square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

Eigen::Affine2d moved(double x, double y) { return Eigen::Affine2d(Eigen::Translation2d(x, y)); }

}  // namespace

TEST_CASE("A point in the bounding box need not be in the shape: that is what shapeFlag is for") {
  const StageObject object(triangle);
  CHECK(hit_test_point(object, {3, 3}));
  CHECK_FALSE(hit_test_point(object, {3, 3}, true));
  CHECK(hit_test_point(object, {1, 1}, true));
  CHECK_FALSE(hit_test_point(object, {5, 1}));
}

TEST_CASE("The boundary belongs to the shape and to the box, its corners too") {
  const StageObject object(triangle);
  for (const bool shape_flag : {false, true})
    for (const Point2& p : {Point2(0, 0), Point2(4, 0), Point2(2, 0), Point2(2, 2), Point2(0, 1)})
      CHECK(hit_test_point(object, p, shape_flag));
  CHECK_FALSE(hit_test_point(object, {std::nextafter(4, 5), 0}));
}

TEST_CASE("A ray through a corner is counted right: points beside each corner of a shape") {
  const StageObject object(letter_l);
  CHECK(hit_test_point(object, {0.5, 1}, true));  // level with the inner corner
  CHECK(hit_test_point(object, {0.5, 2}, true));
  CHECK_FALSE(hit_test_point(object, {2, 2}, true));
  CHECK_FALSE(hit_test_point(object, {1.5, 3}, true));  // level with the top
  const StageObject diamond(std::vector<Point2>{{0, -1}, {1, 0}, {0, 1}, {-1, 0}});
  CHECK(hit_test_point(diamond, {-0.5, 0}, true));  // the ray leaves through the right corner
  CHECK_FALSE(hit_test_point(diamond, {-0.75, 0.75}, true));
}

TEST_CASE("Either way round, an outline is the same shape") {
  const std::vector<Point2> turned(triangle.rbegin(), triangle.rend());
  CHECK(hit_test_point(StageObject(turned), {1, 1}, true));
  CHECK_FALSE(hit_test_point(StageObject(turned), {3, 3}, true));
}

TEST_CASE("Where an outline crosses itself, the even-odd rule leaves a hole") {
  std::vector<Point2> star;
  for (int i = 0; i < 5; ++i)
    star.emplace_back(std::sin(i * 4 * std::numbers::pi / 5), std::cos(i * 4 * std::numbers::pi / 5));
  const StageObject object(star);
  CHECK_FALSE(hit_test_point(object, {0, 0}, true));
  CHECK(hit_test_point(object, {0, 0.7}, true));
}

TEST_CASE("Points are those of the stage: in the object's own coordinates they miss") {
  const StageObject object(square, moved(10, 0));
  CHECK(hit_test_point(object, {10.5, 0.5}, true));
  CHECK_FALSE(hit_test_point(object, {0.5, 0.5}));
}

TEST_CASE("An object that is turned has the bounding box of what stands on the stage") {
  const StageObject object(square, Eigen::Affine2d(Eigen::Rotation2Dd(std::numbers::pi / 4)));
  CHECK(object.bounding_box().high.x() == Approx(std::sqrt(2.0)));
  CHECK(hit_test_point(object, {1.2, 1.2}));
  CHECK_FALSE(hit_test_point(object, {1.2, 1.2}, true));
}

TEST_CASE("hitTestObject compares boxes only: they overlap, and the shapes do not") {
  const std::vector<Point2> facing{{4, 4}, {4, 0.5}, {0.5, 4}};
  const StageObject a(triangle), b(facing);
  CHECK(hit_test_object(a, b));
  CHECK_FALSE(overlap(a, b));
}

TEST_CASE("Boxes that touch are a hit, the next number beyond is none") {
  CHECK(hit_test_object(StageObject(square), StageObject(square, moved(2, 2))));
  CHECK(overlap(StageObject(square), StageObject(square, moved(2, 2))));
  CHECK_FALSE(hit_test_object(StageObject(square), StageObject(square, moved(std::nextafter(2, 3), 0))));
}

TEST_CASE("Shapes overlap if their sides cross, or one is within the other") {
  CHECK(overlap(StageObject(square), StageObject(square, moved(1, 0.5))));
  const StageObject large(square, Eigen::Affine2d(Eigen::Scaling(3.0)));
  CHECK(overlap(StageObject(square), large));
  CHECK(overlap(large, StageObject(square)));
  CHECK_FALSE(overlap(StageObject(letter_l), StageObject(square, moved(2.5, 2.5))));
}

TEST_CASE(
    "A ray through a corner counts one side where the outline passes through it, and none or two where it "
    "only touches") {
  const StageObject diamond(std::vector<Point2>{{1, 0}, {0, 1}, {-1, 0}, {0, -1}});
  CHECK(hit_test_point(diamond, {0, 0}, true));  // the ray leaves by the corner (1, 0)
  const StageObject valley(std::vector<Point2>{{2, -1}, {3, 0}, {4, -1}, {4, 1}, {-1, 1}, {-1, -1}});
  CHECK(hit_test_point(valley, {0, 0}, true));  // it touches the corner (3, 0), and leaves at (4, 0)
  CHECK_FALSE(hit_test_point(StageObject(std::vector<Point2>{{-1, -1}, {0, 0}, {1, -1}}), {-0.5, 0}, true));
}

TEST_CASE("The pointer picks what was drawn last, by its shape") {
  const std::array objects{StageObject(square), StageObject(triangle), StageObject(square, moved(3.5, 3.5))};
  CHECK(pick(objects, {0.5, 0.5}) == 1);
  CHECK(pick(objects, {-0.5, -0.5}) == 0);
  CHECK(pick(objects, {3, 3}) == 2);
  CHECK_FALSE(pick(objects, {2.2, 2.2}));  // in the triangle's box, but not in its shape
}

TEST_CASE("Objects of no corner, one, or two are hit as what they are") {
  CHECK_FALSE(hit_test_point(StageObject({}), {0, 0}));
  CHECK_FALSE(hit_test_object(StageObject({}), StageObject(square)));
  CHECK_FALSE(overlap(StageObject({}), StageObject({})));
  const StageObject point(std::vector<Point2>{{1, 1}}), segment(std::vector<Point2>{{0, 0}, {2, 2}});
  CHECK(hit_test_point(point, {1, 1}, true));
  CHECK(hit_test_point(segment, {1, 1}, true));
  CHECK_FALSE(hit_test_point(segment, {1, 1.5}, true));
  CHECK(overlap(point, segment));
}

TEST_CASE("A point within rounding of a slanted side is on it") {
  const StageObject object(std::vector<Point2>{{0, 0}, {3, 1}, {0, 1}});
  const Point2 third(1.0, 1.0 / 3);  // 1/3 is rounded
  CHECK(hit_test_point(object, third, true));
  CHECK_FALSE(hit_test_point(object, {1.0, 1.0 / 3 - 1e-14}, true));
}

TEST_CASE("A corner that is not finite is refused, on the stage too") {
  CHECK_THROWS_AS(StageObject(std::vector<Point2>{{NAN, 0}}), std::invalid_argument);
  CHECK_THROWS_AS(StageObject(std::vector<Point2>{{1e200, 0}}, Eigen::Affine2d(Eigen::Scaling(1e200))),
                  std::invalid_argument);
}
