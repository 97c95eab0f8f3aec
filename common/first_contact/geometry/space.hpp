#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cfloat>
#include <span>
#include <stdexcept>
#include <string>

// What would give other answers than those promised is refused, not computed (contact.hpp).
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error \
    "First Contact does not work with -ffast-math: it flushes small numbers to zero, also inside the library."
#endif
#if FLT_EVAL_METHOD != 0
#error \
    "First Contact needs doubles that are rounded as doubles: on 32-bit x86 compile with -msse2 -mfpmath=sse."
#endif

/// Collision detection and tweened animation, chapter by chapter.
namespace first_contact {

/// A vector of float, double or another floating-point number.
template <class Scalar>
using Vector3 = Eigen::Matrix<Scalar, 3, 1>;

/// A position in space, in the caller's unit of length.
using Point = Vector3<double>;
/// A direction, a displacement or a velocity.
using Vector = Vector3<double>;

/// How Eigen lays out what it could load at once: column by column, and never aligned to more than a double.
/// The alignment that it would choose depends on the compiler's options (-mavx2, -march=native), so that a
/// program and a library that were compiled apart would take each other's shapes for something else.
inline constexpr int unaligned = Eigen::ColMajor | Eigen::DontAlign;

/// A point or a direction with its fourth coordinate w (paper, 1.2), or a plane [N, D].
using Homogeneous = Eigen::Matrix<double, 4, 1, unaligned>;
/// A point, a direction or a velocity in the plane.
using Vector2 = Eigen::Matrix<double, 2, 1, unaligned>;

static_assert(sizeof(Point) == 3 * sizeof(double) && alignof(Point) == alignof(double));
static_assert(sizeof(Homogeneous) == 4 * sizeof(double) && alignof(Homogeneous) == alignof(double));
static_assert(sizeof(Vector2) == 2 * sizeof(double) && alignof(Vector2) == alignof(double));
static_assert(!Eigen::Matrix3d::IsRowMajor && sizeof(Eigen::Index) == sizeof(std::ptrdiff_t),
              "First Contact needs Eigen's own default order and index");

/// A point as a 4-vector: w = 1, so that translations move it.
inline Homogeneous as_point(const Point& p) { return {p.x(), p.y(), p.z(), 1.0}; }
/// A direction as a 4-vector: w = 0, so that translations leave it alone (paper, 1.2).
inline Homogeneous as_direction(const Vector& v) { return {v.x(), v.y(), v.z(), 0.0}; }

/// The length of a vector, however long or short, to within 2 eps. The same for the same three numbers
/// everywhere; Eigen's own `norm` and `stableNorm` add in an order that depends on options and on where a
/// vector lies in memory.
double norm(const Vector& v);
/// v / |v|; zero if v is.
Vector normalized(const Vector& v);

/// The mean of the points, added one after the other, of which there must be at least one.
Point mean(std::span<const Point> points);

/// The number at the part t of the way from a to b: exactly a at 0 and b at 1, and never back on the way.
/// (std::lerp says as much, but not which number.)
double lerp(double a, double b, double t);

/// No coordinate, radius or displacement may be larger: then no sum of a few of them overflows.
/// \see contact.hpp
inline constexpr double largest_length = 0x1p1000;  // 1.07e301

/// Is every coordinate a number, and none larger than `largest_length`?
inline bool in_range(const Vector& v) { return (v.array().abs() <= largest_length).all(); }

/// Refuses a vector with a coordinate that is infinite, not a number, or larger than `largest_length`.
/// \throws std::invalid_argument that names `what`, its value and the rule.
void require_finite(const Vector& value, const std::string& what);
/// Refuses a length that is negative, infinite, not a number, or larger than `largest_length`.
/// \throws std::invalid_argument that names `what`, its value and the rule.
void require_length(double value, const std::string& what);

/// A vector as text, "1, -2, 0.5", for messages and reports.
std::string to_text(const Vector& value);

}  // namespace first_contact
