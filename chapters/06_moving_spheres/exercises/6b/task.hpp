#pragma once
#include "workbook/vectors.hpp"

// 6b: when do two balls meet, with floats alone? The task is in task.md.
using namespace workbook;

/// A vector of floats: 24 bits each.
struct Float3 {
  float x = 0, y = 0, z = 0;
};
inline Float3 operator+(Float3 a, Float3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Float3 operator-(Float3 a, Float3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Float3 operator*(float s, Float3 a) { return {s * a.x, s * a.y, s * a.z}; }
inline float dot(Float3 a, Float3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Float3 cross(Float3 a, Float3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

using Signature = std::optional<float>(const Float3& w, const Float3& u, float d);
#define EXERCISE_FUNCTION meet
