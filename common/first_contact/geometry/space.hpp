#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <stdexcept>
#include <string>

/// Collision detection and tweened animation, chapter by chapter.
namespace first_contact {

/// A position in space, in the caller's unit of length.
using Point = Eigen::Vector3d;
/// A direction, a displacement or a velocity.
using Vector = Eigen::Vector3d;
/// A point or a direction with its fourth coordinate w (paper, 1.2), or a plane [N, D].
using Homogeneous = Eigen::Vector4d;

/// A point as a 4-vector: w = 1, so that translations move it.
inline Homogeneous as_point(const Point& p) { return {p.x(), p.y(), p.z(), 1.0}; }
/// A direction as a 4-vector: w = 0, so that translations leave it alone (paper, 1.2).
inline Homogeneous as_direction(const Vector& v) { return {v.x(), v.y(), v.z(), 0.0}; }

/// Refuses a vector with a coordinate that is infinite or not a number.
/// \throws std::invalid_argument that names `what`, its value and the rule.
void require_finite(const Vector& value, const std::string& what);
/// Refuses a length that is negative, infinite or not a number.
/// \throws std::invalid_argument that names `what`, its value and the rule.
void require_length(double value, const std::string& what);

/// A vector as text, "1, -2, 0.5", for messages and reports.
std::string to_text(const Vector& value);

}  // namespace first_contact
