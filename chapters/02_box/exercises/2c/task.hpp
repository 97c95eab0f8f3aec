#pragma once
#include "workbook/vectors.hpp"

// 2c: is a box certainly out of sight? The task is in task.md.
using namespace workbook;

using Signature = bool(const std::array<Plane, 6>& frustum, const Box& box);
#define EXERCISE_FUNCTION rejected
