#pragma once
#include "first_contact/geometry/box.hpp"
#include "first_contact/geometry/plane.hpp"
#include "first_contact/geometry/space.hpp"
#include "first_contact/geometry/sphere.hpp"

namespace first_contact {

/// A 4x4 matrix that acts on points and directions as 4-vectors.
using Matrix = Eigen::Matrix<double, 4, 4, unaligned>;
/// A rotation as four numbers, of any length but zero.
using Quaternion = Eigen::Quaternion<double, unaligned>;
/// Its length, however long or short.
double norm(const Quaternion& q);
/// The same rotation by four numbers of length 1, to within 4 eps, however long or short they were: any but four zeros.
Quaternion normalized(const Quaternion& q);

/// An invertible map of space by a 4x4 matrix on homogeneous coordinates (paper, 1.2 and 2.4.2): affine if
/// its last row is [0, 0, 0, 1], otherwise projective. Planes go by the inverse transpose: that keeps E.Q =
/// 0.
class Transform {
 public:
  /// \throws std::invalid_argument if an entry is not finite, or the matrix is singular: if its determinant
  ///     is zero to within the rounding of its own terms.
  /// \see is_singular
  explicit Transform(const Matrix& m);

  /// The affine map Q -> A Q + v, such as a scaling, a shear or a reflection.
  static Transform affine(const Eigen::Matrix3d& linear, const Vector& translation = Vector::Zero());

  /// What an eye at the origin sees that looks along -z: the pyramid between two planes across the line of
  /// sight is mapped onto the cube [-1, 1]^3, by the division by w = -z.
  /// \param view_angle from the lower to the upper plane, in radians, between 0 and pi
  /// \param aspect width of the picture divided by its height
  /// \param near_z,far_z distances from the eye to the two planes, 0 < near_z < far_z
  /// \throws std::invalid_argument that names the value and the rule; also where an entry of the matrix or of its
  ///     inverse would leave the range of double, as the cotangent of a view angle of 10^-309 does
  static Transform perspective(double view_angle, double aspect, double near_z, double far_z);

  /// The 4x4 matrix M.
  const Matrix& matrix() const { return matrix_; }
  /// Does it leave w alone?
  bool is_affine() const;
  /// The way back.
  Transform inverse() const { return {inverse_, matrix_}; }
  /// First `first`, then this one.
  Transform after(const Transform& first) const;

  /// The plane that is mapped onto z = 1, the far side of the cube, times any positive number: row 4 less row
  /// 3 of M. Of a perspective it comes from the distances themselves: in M, near and far cancel, and from far
  /// / near = 10^16 on nothing is left of the far plane. It goes along with `after`.
  const Homogeneous& far_side() const { return far_side_; }

  /// The 4-vector M X, not yet divided by w.
  Homogeneous apply(const Homogeneous& x) const;
  /// A point: M [Q, 1], divided by its w.
  /// \throws std::domain_error if a projective map sends it to infinity (w = 0).
  Point point(const Point& q) const;
  /// A direction: M [V, 0], which no translation moves.
  /// \throws std::domain_error if the map is projective: it turns a direction into a point, its vanishing
  /// point.
  Vector direction(const Vector& v) const;
  /// The plane of the mapped points: E M^-1, the inverse transpose. The side of a point is kept where its w >
  /// 0.
  /// \throws std::invalid_argument if the plane goes to infinity.
  Plane plane(const Plane& e) const;

 private:
  Transform(const Matrix& m, const Matrix& its_inverse)
      : matrix_(m), inverse_(its_inverse), far_side_(m.row(3) - m.row(2)) {}

  Matrix matrix_, inverse_;
  Homogeneous far_side_;
};

/// Is the determinant zero, to within the rounding of its own terms? It is a sum of 24 products of four
/// entries; the sum of their absolute values, the permanent of |M|, is the yardstick, so that no scaling of
/// rows or columns (other units, a far translation) changes the answer.
bool is_singular(const Matrix& m);

/// Four roundings of entries, three of products and five of sums are on the way of each of the 24 terms of a
/// determinant: 12 halves of an epsilon.
/// \see is_singular
inline constexpr double singular_tolerance = 6 * std::numeric_limits<double>::epsilon();

/// A motion of a rigid body: first turned, then moved. It keeps lengths and angles, so that a sphere remains
/// a sphere and a box a box.
class Rigid {
 public:
  /// No motion.
  Rigid();
  /// \param turn any quaternion but zero; it is divided by its length.
  /// \throws std::invalid_argument if the quaternion is zero, or one of its numbers or a coordinate is not finite.
  Rigid(const Quaternion& turn, const Vector& shift);

  /// A shift alone.
  static Rigid moved_by(const Vector& shift);
  /// Turned about an axis through the origin, by an angle in radians, anticlockwise as seen from the axis'
  /// tip.
  /// \throws std::invalid_argument if the axis is zero, or a value is not finite.
  static Rigid turned(const Vector& axis, double angle);

  /// How it turns.
  const Eigen::Matrix3d& rotation() const { return rotation_; }
  /// By how much it moves, after it has turned.
  const Vector& translation() const { return translation_; }
  /// The way back.
  Rigid inverse() const;
  /// First `first`, then this one.
  Rigid after(const Rigid& first) const;
  /// The same motion as a 4x4 matrix.
  Transform transform() const;

  /// A point, turned and moved.
  Point point(const Point& q) const;
  /// A direction, turned.
  Vector direction(const Vector& v) const;
  /// The plane of the moved points.
  Plane plane(const Plane& e) const;
  /// A sphere, its centre moved.
  Sphere sphere(const Sphere& s) const;
  /// A box, moved and turned.
  Box box(const Box& b) const;

 private:
  Rigid(const Eigen::Matrix3d& turn, const Vector& shift) : rotation_(turn), translation_(shift) {}

  Eigen::Matrix3d rotation_;
  Vector translation_;
};

}  // namespace first_contact
