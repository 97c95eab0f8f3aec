#pragma once
#include "workbook/vectors.hpp"

// 3a: while is a path in an upright box? The task is in task.md.
using namespace workbook;

/// A span of time.
struct Stay {
  double enters = 0, leaves = 0;
};

using Signature = std::optional<Stay>(const Bounds& box, Point S0, Vector V);
#define EXERCISE_FUNCTION stay_in
