#pragma once
#include "workbook/vectors.hpp"

// 3c: is a point in a polygon? The task is in task.md.
using namespace workbook;

using Signature = bool(const std::vector<Vector2>& polygon, Vector2 P);
#define EXERCISE_FUNCTION inside
