#include "first_contact/geometry/transform.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

#include "catch.hpp"

using namespace first_contact;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();

const Transform stretch = Transform::affine(Eigen::DiagonalMatrix<double, 3>(1, 1, 4), {0, 0, 5});
const Transform slanted =
    Transform::affine((Eigen::Matrix3d() << 2, 1, 0, 0, 3, -1, 1, 0, 1).finished(), {4, -5, 6});
const Transform camera = Transform::perspective(pi / 2, 1.5, 1, 100);
const Rigid motion = Rigid::moved_by({3, -1, 2}).after(Rigid::turned({1, 2, -1}, 0.7));

// Three points of a plane that are not on one line.
std::array<Point, 3> points_of(const Plane& e) {
  const Point foot = -e.offset() * e.normal();
  const Vector along = e.normal().unitOrthogonal();
  return {foot, foot + 2 * along, foot - 3 * e.normal().cross(along)};
}

const Plane slope{{1, -2, 2}, 3};
const Plane before_the_eye{{0.5, 0.2, 1}, 3};  // all three of its points have z < 0

}  // namespace

TEST_CASE("A translation moves points and leaves directions alone") {
  const Transform shift = Rigid::moved_by({1, 2, 3}).transform();
  CHECK(shift.point({10, 20, 30}) == Point(11, 22, 33));
  CHECK(shift.direction({10, 20, 30}) == Vector(10, 20, 30));
  CHECK(Rigid::moved_by({1, 2, 3}).direction({10, 20, 30}) == Vector(10, 20, 30));
}
TEST_CASE("A quarter turn about z takes x to y, and y to -x") {
  const Rigid quarter = Rigid::turned({0, 0, 9}, pi / 2);
  CHECK(quarter.point({1, 0, 0}).isApprox(Point(0, 1, 0)));
  CHECK(quarter.point({0, 1, 0}).isApprox(Point(-1, 0, 0)));
}
TEST_CASE("A transformed plane holds the transformed points") {
  for (const Transform& t : {stretch, slanted, motion.transform()})
    for (const Point& p : points_of(slope))
      CHECK(std::abs(t.plane(slope).signed_distance(t.point(p))) < 1e-14);
  for (const Point& p : points_of(before_the_eye))
    CHECK(std::abs(camera.plane(before_the_eye).signed_distance(camera.point(p))) < 1e-14);
  for (const Point& p : points_of(slope))
    CHECK(std::abs(motion.plane(slope).signed_distance(motion.point(p))) < 1e-14);
}
TEST_CASE("The matrix itself, instead of its inverse transpose, would lose a plane under uneven scaling") {
  const Plane roof{{0, 1, 1}, -1};
  const Homogeneous wrong = stretch.apply(roof.coefficients());
  const Plane lost{wrong.head<3>(), wrong.w()};
  const Point on_roof{0, 1, 0};
  REQUIRE(roof.signed_distance(on_roof) == Approx(0).margin(1e-15));
  CHECK(std::abs(stretch.plane(roof).signed_distance(stretch.point(on_roof))) < 1e-15);
  CHECK(std::abs(lost.signed_distance(stretch.point(on_roof))) > 1);
}
TEST_CASE("A rotation is its own inverse transpose, so there the matrix would have served") {
  const Rigid turn = Rigid::turned({1, 2, -1}, 0.7);
  CHECK(turn.plane(slope).coefficients().isApprox(turn.transform().apply(slope.coefficients())));
  CHECK(turn.plane(slope).coefficients().isApprox(turn.transform().plane(slope).coefficients()));
}
TEST_CASE("The side of a plane on which a point lies survives an affine transform, and a mirror too") {
  const Transform mirror = Transform::affine(Eigen::DiagonalMatrix<double, 3>(-1, 1, 1));
  for (const Transform& t : {stretch, slanted, mirror, motion.transform()}) {
    CHECK(t.plane(slope).signed_distance(t.point({9, 0, 0})) > 0);
    CHECK(t.plane(slope).signed_distance(t.point({-9, 0, 0})) < 0);
  }
}
TEST_CASE("A rigid motion keeps distances, to planes as well") {
  const Point p{1, 2, 3};
  const Point q{-4, 0, 7};
  CHECK((motion.point(p) - motion.point(q)).norm() == Approx((p - q).norm()));
  CHECK(motion.plane(slope).signed_distance(motion.point(p)) == Approx(slope.signed_distance(p)));
}
TEST_CASE("Transforms in a row are one transform, of points and of planes") {
  const Transform both = slanted.after(stretch);
  CHECK(both.point({1, 2, 3}).isApprox(slanted.point(stretch.point({1, 2, 3}))));
  CHECK(both.plane(slope).coefficients().isApprox(slanted.plane(stretch.plane(slope)).coefficients()));
  const Rigid turn = Rigid::turned({0, 1, 0}, 2);
  CHECK(motion.after(turn).point({1, 2, 3}).isApprox(motion.point(turn.point({1, 2, 3}))));
}
TEST_CASE("The inverse undoes a transform") {
  for (const Transform& t : {stretch, slanted, camera}) {
    CHECK(t.inverse().point(t.point({1, 2, -3})).isApprox(Point(1, 2, -3)));
    CHECK(t.inverse().plane(t.plane(slope)).coefficients().isApprox(slope.coefficients()));
  }
  CHECK(motion.inverse().point(motion.point({1, 2, 3})).isApprox(Point(1, 2, 3)));
}
TEST_CASE(
    "A perspective takes the near plane to z = -1, the far plane to z = 1, and the edges of sight to +-1") {
  CHECK(camera.point({0, 0, -1}).isApprox(Point(0, 0, -1)));
  CHECK(camera.point({0, 0, -100}).isApprox(Point(0, 0, 1)));
  CHECK(camera.point({15, 10, -10}).head<2>().isApprox(Eigen::Vector2d(1, 1)));
}
TEST_CASE("A perspective keeps straight lines straight, but not the middle in the middle") {
  const Point a = camera.point({-3, 1, -2});
  const Point b = camera.point({5, 2, -8});
  const Point middle = camera.point({1, 1.5, -5});
  CHECK((middle - a).cross(b - a).norm() < 1e-14);
  CHECK_FALSE(middle.isApprox(0.5 * (a + b), 0.01));
}
TEST_CASE("A perspective has no image for the eye, nor one direction for a direction") {
  CHECK_THROWS_AS(camera.point({3, 4, 0}), std::domain_error);
  CHECK_THROWS_AS(camera.direction({1, 0, 0}), std::domain_error);
  CHECK_THROWS_AS(camera.plane(Plane({0, 0, 1}, 0)), std::invalid_argument);  // the plane through the eye
  CHECK(camera.apply(as_direction({1, 0, -1})).w() == 1);                     // its vanishing point instead
}
TEST_CASE("A perspective with impossible values is refused by name") {
  CHECK_THROWS_WITH(Transform::perspective(0, 1, 1, 2), ContainsSubstring("view angle 0"));
  CHECK_THROWS_WITH(Transform::perspective(pi, 1, 1, 2), ContainsSubstring("view angle"));
  CHECK_THROWS_WITH(Transform::perspective(1, -1, 1, 2), ContainsSubstring("aspect -1"));
  CHECK_THROWS_WITH(Transform::perspective(1, 1, 0, 2), ContainsSubstring("near distance 0"));
  CHECK_THROWS_WITH(Transform::perspective(1, 1, 2, 2), ContainsSubstring("far distance 2"));
  CHECK_THROWS_WITH(Transform::perspective(1, 1, 2, infinity), ContainsSubstring("far distance"));
}
TEST_CASE(
    "A perspective whose matrix would leave the range of numbers is refused by the value that leads there") {
  const auto beyond = [](const std::string& what) {
    return what + ": must not lead beyond the range of numbers";
  };
  CHECK_THROWS_WITH(Transform::perspective(5e-324, 1, 1, 2), beyond("view angle 4.94066e-324"));
  CHECK_THROWS_WITH(Transform::perspective(1, 1e-308, 1, 2), beyond("aspect 1e-308"));
  CHECK_THROWS_WITH(Transform::perspective(3, 1e308, 1, 2), beyond("aspect 1e+308"));
  CHECK_THROWS_WITH(Transform::perspective(1, 1, 1e308, 1.5e308), beyond("near distance 1e+308"));
  CHECK_THROWS_WITH(Transform::perspective(1, 1, 5e-324, 1), beyond("near distance 4.94066e-324"));
}
TEST_CASE("A quaternion turns by the ratios of its numbers, however small or large they are") {
  constexpr double least = std::numeric_limits<double>::denorm_min(),
                   most = std::numeric_limits<double>::max();
  for (const double size : {least, 3 * least, 1e-310, 1e-200, 1.0, 1e200, 1e308, most}) {
    CAPTURE(size);
    const Rigid quarter(Quaternion(size, size, 0, 0), {0, 0, 0}),
        third(Quaternion(size, size, size, size), {0, 0, 0});
    CHECK((quarter.point({1, 2, 3}) - Point(1, -3, 2)).norm() < 4e-15);
    CHECK((third.point({1, 2, 3}) - Point(3, 1, 2)).norm() < 4e-15);
    CHECK(norm(normalized(Quaternion(0, 0, size, size))) == Approx(1).epsilon(4e-16));
  }
  CHECK_THROWS_WITH(Rigid(Quaternion(0, 0, 0, 0), {0, 0, 0}), ContainsSubstring("quaternion of length 0"));
  CHECK_THROWS_WITH(Rigid(Quaternion(1, infinity, 0, 0), {0, 0, 0}), ContainsSubstring("of length inf"));
}
TEST_CASE("A singular matrix is refused, also one that is singular but for rounding") {
  CHECK_THROWS_WITH(Transform(Matrix::Zero()), ContainsSubstring("singular"));
  CHECK_THROWS_AS(Transform::affine(Eigen::DiagonalMatrix<double, 3>(1, 0, 1)), std::invalid_argument);
  const Eigen::Matrix3d tenths =
      (Eigen::Matrix3d() << 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9).finished();
  REQUIRE(tenths.determinant() != 0);  // 6.7e-18: rounding alone
  CHECK_THROWS_AS(Transform::affine(tenths), std::invalid_argument);
}
TEST_CASE("Other units or a far translation make no matrix singular") {
  CHECK_NOTHROW(Transform::affine(Eigen::DiagonalMatrix<double, 3>(1, 1, 1e-20)));
  CHECK_NOTHROW(Transform::affine(1e-120 * Eigen::Matrix3d::Identity()));
  CHECK_NOTHROW(Transform::affine(1e120 * Eigen::Matrix3d::Identity()));
  CHECK_NOTHROW(Transform::affine(slanted.matrix().topLeftCorner<3, 3>(), {1e30, 0, -1e30}));
  CHECK_NOTHROW(Transform::perspective(1e-3, 1, 1e-3, 1e6));
}
TEST_CASE("A matrix that is nearly, but truly not, singular is accepted") {
  Eigen::Matrix3d thin = Eigen::Matrix3d::Ones();
  thin.diagonal() *= 1 + 1e-7;  // the determinant is 3e-14, four times what rounding could make of it
  CHECK_NOTHROW(Transform::affine(thin));
}
TEST_CASE(
    "Each of the 24 terms of a determinant alone makes a matrix regular, and two that cancel a singular "
    "one") {
  std::array<int, 4> column{0, 1, 2, 3};
  do {
    Matrix terms = Matrix::Zero();
    for (int row = 0; row < 4; ++row) terms(row, column[static_cast<std::size_t>(row)]) = row + 2;
    CAPTURE(terms);
    CHECK_FALSE(is_singular(terms));
    for (int row = 0; row < 4; ++row) {  // a row more: the same as that one
      Matrix twice = terms;
      twice.row(row) += terms.row((row + 1) % 4);
      CHECK_FALSE(is_singular(twice));
      twice.row((row + 1) % 4) = twice.row(row);
      CHECK(is_singular(twice));
    }
  } while (std::next_permutation(column.begin(), column.end()));
}
TEST_CASE("A determinant of up to six roundings of its terms is none") {
  constexpr double eps = std::numeric_limits<double>::epsilon();
  Eigen::Matrix3d nearly = Eigen::Matrix3d::Ones();  // in the upper left corner: of two terms, 1 + d and -1
  nearly.row(2) = nearly.col(2).transpose() = Eigen::RowVector3d(0, 0, 1);
  nearly(0, 0) = 1 + 11 * eps;
  CHECK_THROWS_AS(Transform::affine(nearly), std::invalid_argument);
  nearly(0, 0) = 1 + 13 * eps;
  CHECK_NOTHROW(Transform::affine(nearly));
}
TEST_CASE("Values that are not finite are refused") {
  Matrix m = Matrix::Identity();
  m(1, 2) = std::nan("");
  CHECK_THROWS_WITH(Transform(m), "transform's matrix with an entry nan: every entry must be finite");
  CHECK_THROWS_AS(Rigid::moved_by({infinity, 0, 0}), std::invalid_argument);
  CHECK_THROWS_AS(Rigid::turned({0, 0, 0}, 1), std::invalid_argument);
  CHECK_THROWS_AS(Rigid::turned({0, 0, 1}, infinity), std::invalid_argument);
  CHECK_THROWS_AS(Rigid(Eigen::Quaterniond(0, 0, 0, 0), {0, 0, 0}), std::invalid_argument);
}
TEST_CASE("A plane so far away that its distance is not finite is refused") {
  const Plane floor({0, 0, 1}, 0);
  CHECK(floor.moved_out(-0x1p1002).offset() == 0x1p1002);
  CHECK_THROWS_WITH(floor.moved_out(std::nan("")),
                    "plane moved out by nan: must be no farther from the origin than 4.29e301 (2^1002)");
  CHECK_THROWS_AS(floor.moved_out(0x1p1003), std::invalid_argument);
  CHECK_THROWS_AS(Plane({0, 0, 1e-300}, 1e10), std::invalid_argument);
  CHECK_NOTHROW(Plane({0, 0, 1e-300}, 1e-295));
}
TEST_CASE("A quaternion of any length gives the same rotation") {
  const Eigen::Quaterniond unit(Eigen::AngleAxisd(1, Vector::UnitX()));
  const Rigid longer(Eigen::Quaterniond(unit.coeffs() * 1e200), {0, 0, 0});
  CHECK(longer.rotation().isApprox(unit.toRotationMatrix()));
}
TEST_CASE("A rigid motion takes a sphere to a sphere and a box to a box") {
  const Sphere sphere = motion.sphere({{1, 2, 3}, 0.5});
  CHECK(sphere.center == motion.point({1, 2, 3}));
  CHECK(sphere.radius == 0.5);
  const Box box{{1, 2, 3}, {4, 0, 0}, {0, 2, 0}, {0, 0, 1}};
  const Box moved = motion.box(box);
  for (std::size_t i = 0; i < 8; ++i) CHECK(moved.vertices()[i].isApprox(motion.point(box.vertices()[i])));
}
