#pragma once
#include "workbook/vectors.hpp"

// 8a: what does an impact do to two velocities? The task is in task.md.
using namespace workbook;

struct Body {
  double mass = 1;
  Vector2 velocity;
};

/// Of the first body and of the second.
struct Velocities {
  Vector2 first, second;
};

using Signature = Velocities(const Body& first, const Body& second, Vector2 N, double e);
#define EXERCISE_FUNCTION impact
