#pragma once
#include "workbook/vectors.hpp"

// 7b: a point of a Bézier curve, by de Casteljau. The task is in task.md.
using namespace workbook;

using Signature = Vector2(const std::vector<Vector2>& points, double t);
#define EXERCISE_FUNCTION bezier
