#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

/// What an exercise is written with: the names of the notes, and nothing that takes long to compile.
namespace workbook {

/// Three numbers: a direction, a displacement, a velocity.
struct Vector {
  double x = 0, y = 0, z = 0;
};
/// Three numbers: a place.
using Point = Vector;

constexpr Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vector operator-(Vector a) { return {-a.x, -a.y, -a.z}; }
constexpr Vector operator*(double s, Vector a) { return {s * a.x, s * a.y, s * a.z}; }
constexpr Vector operator*(Vector a, double s) { return s * a; }
constexpr Vector operator/(Vector a, double s) { return {a.x / s, a.y / s, a.z / s}; }

/// a . b
constexpr double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
/// a x b
constexpr Vector cross(Vector a, Vector b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// The length of a.
inline double norm(Vector a) { return std::sqrt(dot(a, a)); }

/// Two numbers, where a chapter is about the plane.
struct Vector2 {
  double x = 0, y = 0;
};
constexpr Vector2 operator+(Vector2 a, Vector2 b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vector2 operator-(Vector2 a, Vector2 b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vector2 operator*(double s, Vector2 a) { return {s * a.x, s * a.y}; }
constexpr Vector2 operator*(Vector2 a, double s) { return s * a; }
constexpr Vector2 operator/(Vector2 a, double s) { return {a.x / s, a.y / s}; }
/// a . b
constexpr double dot(Vector2 a, Vector2 b) { return a.x * b.x + a.y * b.y; }
/// a.x b.y - a.y b.x: twice the area of the triangle of a and b, with its sign.
constexpr double cross(Vector2 a, Vector2 b) { return a.x * b.y - a.y * b.x; }
/// The length of a.
inline double norm(Vector2 a) { return std::sqrt(dot(a, a)); }

/// The plane of all points Q with N . Q + D = 0 (1.2.2).
struct Plane {
  Vector N;
  double D = 0;
};
/// E . Q with the fourth coordinate 1 for the point Q: N . Q + D.
constexpr double dot(const Plane& E, Point Q) { return dot(E.N, Q) + E.D; }

/// The box of all points Q + aR + bS + cT with a, b, c from -1/2 to 1/2 (1.3).
struct Box {
  Point Q;
  Vector R, S, T;
};

/// An upright box: all points that are nowhere less than `least` nor more than `most`.
struct Bounds {
  Point least, most;
};

}  // namespace workbook
