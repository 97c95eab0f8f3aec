#include "first_contact/geometry/transform.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/refuse.hpp"
#include "first_contact/geometry/unit_scale.hpp"

namespace first_contact {

namespace {

void require(bool rule, const std::string& what, double value, const std::string& text) {
  if (!rule) refuse(what, value, "must be " + text);
}

void require_invertible(const std::string& what, double value, double entry) {
  if (!std::isfinite(entry) || !std::isfinite(1 / entry))
    refuse(what, value, "must not lead beyond the range of numbers");
}

// The determinant (sign -1) or the permanent (sign +1), by the 2x2 minors of the upper rows and those of the
// lower.
double sum_of_minors(const Matrix& m, double sign) {
  const auto minor = [&](int row, int i, int j) {
    return m(row, i) * m(row + 1, j) + sign * m(row, j) * m(row + 1, i);
  };
  return (minor(0, 0, 1) * minor(2, 2, 3) + minor(0, 2, 3) * minor(2, 0, 1)) +
         (minor(0, 0, 3) * minor(2, 1, 2) + minor(0, 1, 2) * minor(2, 0, 3)) +
         sign * (minor(0, 0, 2) * minor(2, 1, 3) + minor(0, 1, 3) * minor(2, 0, 2));
}

// Each row multiplied by the power of two that brings its largest entry to [1/2, 1), and then each column: exact,
// and the terms of the determinant stay within the range of double.
Matrix balanced(Matrix m) {
  const auto to_one = [](auto&& line) {
    int exponent = 0;
    std::frexp(line.cwiseAbs().maxCoeff(), &exponent);
    for (double& entry : line.reshaped()) entry = std::ldexp(entry, -exponent);
  };
  for (int row = 0; row < 4; ++row) to_one(m.row(row));
  for (int column = 0; column < 4; ++column) to_one(m.col(column));
  return m;
}

// By elimination (Gauss and Jordan). Each step takes the largest entry that is left for its pivot, so that no
// factor is larger than 1.
Matrix inverse_of(Matrix rest) {
  Matrix inverse = Matrix::Identity();
  std::array<Eigen::Index, 4> order{0, 1, 2, 3};  // of the unknowns, as the columns were exchanged
  for (Eigen::Index step = 0; step < 4; ++step) {
    Eigen::Index row = 0, column = 0;
    rest.bottomRightCorner(4 - step, 4 - step).cwiseAbs().maxCoeff(&row, &column);
    rest.row(step).swap(rest.row(step + row));
    inverse.row(step).swap(inverse.row(step + row));
    rest.col(step).swap(rest.col(step + column));
    std::swap(order[static_cast<std::size_t>(step)], order[static_cast<std::size_t>(step + column)]);
    for (Eigen::Index other = 0; other < 4; ++other) {
      if (other == step) continue;
      const double factor = rest(other, step) / rest(step, step);
      rest.row(other) -= factor * rest.row(step);
      inverse.row(other) -= factor * inverse.row(step);
    }
  }
  Matrix in_order;
  for (Eigen::Index i = 0; i < 4; ++i)
    in_order.row(static_cast<Eigen::Index>(order[static_cast<std::size_t>(i)])) = inverse.row(i) / rest(i, i);
  return in_order;
}

}  // namespace

double norm(const Quaternion& q) {
  const double unit = unit_scale(q.coeffs().cwiseAbs().maxCoeff());
  return std::sqrt(squared_norm(unit * q.coeffs())) / unit;
}

Quaternion normalized(const Quaternion& q) {
  const Homogeneous moderate = unit_scale(q.coeffs().cwiseAbs().maxCoeff()) * q.coeffs();
  return Quaternion(Homogeneous(moderate / std::sqrt(squared_norm(moderate))));
}

bool is_singular(const Matrix& m) {
  const Matrix b = balanced(m);
  return !(std::abs(sum_of_minors(b, -1)) > singular_tolerance * sum_of_minors(b.cwiseAbs(), +1));
}

Transform::Transform(const Matrix& m) : matrix_(m) {
  for (const double entry : m.reshaped())
    if (!std::isfinite(entry))
      refuse("transform's matrix with an entry", entry, "every entry must be finite");
  if (is_singular(m)) refuse("transform's matrix", "must not be singular");
  inverse_ = inverse_of(m);
  if (is_affine()) inverse_.row(3) = m.row(3);  // [0, 0, 0, 1] exactly
  far_side_ = m.row(3) - m.row(2);
  if (!inverse_.allFinite()) refuse("transform's matrix", "must have a finite inverse");
}

Transform Transform::affine(const Eigen::Matrix3d& linear, const Vector& translation) {
  Matrix m = Matrix::Identity();
  m.topLeftCorner<3, 3>() = linear;
  m.topRightCorner<3, 1>() = translation;
  return Transform(m);
}

Transform Transform::perspective(double view_angle, double aspect, double near_z, double far_z) {
  require(view_angle > 0 && view_angle < std::numbers::pi, "view angle", view_angle, "between 0 and pi");
  require(aspect > 0 && std::isfinite(aspect), "aspect", aspect, "positive and finite");
  require(near_z > 0 && std::isfinite(near_z), "near distance", near_z, "positive and finite");
  require(far_z > near_z && std::isfinite(far_z), "far distance", far_z, "finite, and beyond the near one");
  const double scale = 1 / std::tan(view_angle / 2), across = scale / aspect;
  require_invertible("view angle", view_angle, scale);
  require_invertible("aspect", aspect, across);
  const double unit = unit_scale(far_z), n = unit * near_z, f = unit * far_z, depth = f - n;
  const double shift = depth == f ? near_z : f * n / depth / unit;  // 1 / (1 / n - 1 / f)
  require_invertible("near distance", near_z, 2 * shift);
  Matrix m;
  m << across, 0, 0, 0,                    //
      0, scale, 0, 0,                      //
      0, 0, -(f + n) / depth, -2 * shift,  //
      0, 0, -1, 0;
  Transform eye(m);
  eye.far_side_ = {0, 0, 1, far_z};
  return eye;
}

bool Transform::is_affine() const { return matrix_.row(3) == Homogeneous(0, 0, 0, 1).transpose(); }

Transform Transform::after(const Transform& first) const {
  Transform both{product(matrix_, first.matrix_), product(first.inverse_, inverse_)};
  both.far_side_ = product(first.matrix_.transpose(), far_side_);
  return both;
}

Homogeneous Transform::apply(const Homogeneous& x) const { return product(matrix_, x); }

//! [transform_point]
Point Transform::point(const Point& q) const {
  const Homogeneous image = apply(as_point(q));
  if (image.w() == 0) throw std::domain_error("point " + to_text(q) + ": the transform sends it to infinity");
  return image.head<3>() / image.w();
}

Vector Transform::direction(const Vector& v) const {
  if (!is_affine())
    throw std::domain_error("direction " + to_text(v) + ": only an affine transform keeps directions");
  return apply(as_direction(v)).head<3>();
}
//! [transform_point]

//! [transform_plane]
Plane Transform::plane(const Plane& e) const {
  const Homogeneous image = product(inverse_.transpose(), e.coefficients());
  return {image.head<3>(), image.w()};
}
//! [transform_plane]

Rigid::Rigid() : Rigid(Eigen::Matrix3d::Identity(), Vector::Zero()) {}

Rigid::Rigid(const Quaternion& turn, const Vector& shift) : translation_(shift) {
  require_finite(translation_, "rigid motion's translation");
  if (!turn.coeffs().allFinite() || turn.coeffs().isZero(0))
    refuse("rotation's quaternion of length", norm(turn), "must be finite and not zero");
  rotation_ = normalized(turn).toRotationMatrix();
}

Rigid Rigid::moved_by(const Vector& shift) { return {Quaternion::Identity(), shift}; }

Rigid Rigid::turned(const Vector& axis, double angle) {
  require_finite(axis, "axis of rotation");
  require(std::isfinite(angle), "angle of rotation", angle, "finite");
  if (axis.isZero(0)) refuse("axis of rotation " + to_text(axis), "must not be zero");
  return {Quaternion(Eigen::AngleAxisd(angle, normalized(axis))), Vector::Zero()};
}

Rigid Rigid::inverse() const {
  const Eigen::Matrix3d back = rotation_.transpose();
  return {back, product(back, -translation_)};
}

Rigid Rigid::after(const Rigid& first) const {
  return {product(rotation_, first.rotation_), point(first.translation_)};
}

Point Rigid::point(const Point& q) const { return product(rotation_, q) + translation_; }

Vector Rigid::direction(const Vector& v) const { return product(rotation_, v); }

Transform Rigid::transform() const { return Transform::affine(rotation_, translation_); }

// A rotation is its own inverse transpose; D changes by what the translation adds to N.Q.
Plane Rigid::plane(const Plane& e) const {
  const Vector normal = direction(e.normal());
  return {normal, e.offset() - dot(normal, translation_)};
}

Sphere Rigid::sphere(const Sphere& s) const { return {point(s.center), s.radius}; }

Box Rigid::box(const Box& b) const {
  return {point(b.center), direction(b.r), direction(b.s), direction(b.t)};
}

}  // namespace first_contact
