#include "first_contact/motion/rigid_tween.hpp"

#include <limits>
#include <numbers>

#include "catch.hpp"
#include "chance.hpp"

using namespace first_contact;

namespace {

const double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("A rigid tween turns at constant angular speed, by the shorter way, and hits its poses") {
  const auto about_z = [](double angle) {
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vector::UnitZ()));
  };
  const double pi = std::numbers::pi;
  Eigen::Quaterniond far = about_z(pi / 2);
  far.coeffs() *= -3;  // the same orientation, not of unit length, and on the long way round
  const RigidTween tween({{0, {1, 0, 0}, about_z(0)}, {1, {3, 2, 0}, far}});
  for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const Rigid pose = tween.at(t);
    CHECK((pose.rotation() - about_z(t * pi / 2).toRotationMatrix()).norm() < 1e-14);
    CHECK((pose.translation() - Vector(1 + 2 * t, 2 * t, 0)).norm() == 0);
  }
  CHECK(tween.at(-1).translation() == Vector(1, 0, 0));
  CHECK(tween.at(9).translation() == Vector(3, 2, 0));
}

TEST_CASE("Between two poses a body stays rigid, where tweening the matrices' entries would shrink it") {
  const Eigen::Quaterniond a(1, 0, 0, 0), b(0.1, 0.3, -0.8, 0.4);
  const RigidTween tween({{0, {0, 0, 0}, a}, {1, {1, 0, 0}, b}});
  for (double t = 0; t <= 1; t += 0.125) {
    const Matrix m = tween.at(t).transform().matrix();
    CHECK(
        (m.topLeftCorner<3, 3>() * m.topLeftCorner<3, 3>().transpose() - Eigen::Matrix3d::Identity()).norm() <
        1e-14);
    CHECK(m.row(3) == Eigen::RowVector4d(0, 0, 0, 1));
  }
  const Eigen::Matrix3d entries = 0.5 * (tween.at(0).rotation() + tween.at(1).rotation());
  CHECK(entries.determinant() < 0.5);
}

TEST_CASE("A rigid tween refuses an orientation that is zero") {
  CHECK_THROWS_AS(RigidTween({{0, {0, 0, 0}, Eigen::Quaterniond(0, 0, 0, 0)}}), std::invalid_argument);
  CHECK_THROWS_AS(RigidTween({{0, {0, 0, 0}, Eigen::Quaterniond(not_a_number, 0, 0, 0)}}),
                  std::invalid_argument);
}

TEST_CASE("A pose goes in and out as a 4x4 matrix, whatever the turn") {
  const std::uint64_t seed = 1721;
  Chance chance(seed);
  for (int i = 0; i < 200; ++i) {
    CAPTURE(seed, i);
    const double angle = i < 8 ? i * std::numbers::pi / 4 : chance.uniform(-3.14, 3.14);
    const Matrix m = Rigid::moved_by(chance.vector(9))
                         .after(Rigid::turned(chance.direction(), angle))
                         .transform()
                         .matrix();
    const RigidTween tween({pose(0, m)});
    CHECK((tween.matrix(0) - m).cwiseAbs().maxCoeff() < 1e-14);
  }
  for (const Vector& axis : {Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)}) {  // half turns: w is 0
    const Matrix m = Rigid::turned(axis, std::numbers::pi).transform().matrix();
    CHECK((RigidTween({pose(0, m)}).matrix(0) - m).cwiseAbs().maxCoeff() < 1e-15);
  }
}

TEST_CASE("A pose that is turned half round, or nearly so, keeps its digits, whatever its axis") {
  for (const Vector& axis :
       {Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1), Vector(1, 2, -3), Vector(-3, 1, 0.1)})
    for (const double lacking : {0.0, 1e-12, 1e-9, 1e-6, 1e-3}) {
      CAPTURE(axis, lacking);
      const Matrix there = Rigid::turned(axis, std::numbers::pi - lacking).transform().matrix();
      const Quaternion turn = pose(0, there).orientation.normalized();
      CHECK((turn.toRotationMatrix() - there.topLeftCorner<3, 3>()).cwiseAbs().maxCoeff() <= 1e-15);
    }
}

TEST_CASE("A matrix that stretches, shears, mirrors or is projective is no pose") {
  Matrix stretched = Matrix::Identity(), sheared = stretched, mirrored = stretched, projective = stretched;
  stretched(0, 0) = 1.001;
  sheared(0, 1) = 0.001;
  mirrored(2, 2) = -1;
  projective(3, 0) = 1e-9;
  CHECK_THROWS_WITH(pose(0, stretched), "pose's matrix: must not stretch or shear");
  CHECK_THROWS_AS(pose(0, sheared), std::invalid_argument);
  CHECK_THROWS_WITH(pose(0, mirrored), "pose's matrix: must not mirror");
  CHECK_THROWS_WITH(pose(0, projective), "pose's last row 1e-09, 0, 0, 1: must be 0, 0, 0, 1");
  stretched(0, 0) = not_a_number;
  CHECK_THROWS_AS(pose(0, stretched), std::invalid_argument);
}

TEST_CASE("A body goes along a curve while it turns, both by the same part of the way") {
  const double pi = std::numbers::pi;
  const Path path = Path::bezier({{2, 4, 0}}, true);
  const RigidTween tween({{0, {0, 0, 0}, Quaternion(1, 0, 0, 0), ease::in_quadratic, path},
                          {2, {4, 0, 0}, Quaternion(0, 0, 0, 1)}});
  const Leg way(path, {0, 0, 0}, {4, 0, 0});
  const Rigid half = tween.at(1);  // a quarter of the way
  CHECK((half.translation() - way.at(0.25)).norm() < 1e-14);
  CHECK((half.rotation() - Rigid::turned({0, 0, 1}, pi / 4).rotation()).norm() < 1e-14);
  CHECK(tween.turn(0).angle == Approx(pi).epsilon(1e-15));
}

TEST_CASE("The turn from one pose to the next is about its axis, and the shorter of two") {
  const std::uint64_t seed = 1722;
  Chance chance(seed);
  for (int i = 0; i < 100; ++i) {
    const Quaternion a(Eigen::AngleAxisd(chance.uniform(-3, 3), chance.direction()));
    const Quaternion b(Eigen::AngleAxisd(chance.uniform(-3, 3), chance.direction()));
    const RigidTween tween({{0, {0, 0, 0}, a}, {1, {0, 0, 0}, b}});
    const Turn turn = tween.turn(0);
    CAPTURE(seed, i, turn.angle);
    CHECK(turn.angle <= std::numbers::pi * (1 + 1e-15));
    const double part = chance.uniform(0, 1);
    const Rigid there = Rigid::turned(turn.axis, part * turn.angle).after(tween.at(0));
    CHECK((there.rotation() - tween.at(part).rotation()).norm() < 1e-13);
  }
}
