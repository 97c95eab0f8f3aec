#pragma once
#include "workbook/vectors.hpp"

// 5a: which motion is left along a wall? The task is in task.md.
using namespace workbook;

using Signature = Vector(Vector w, Vector N);
#define EXERCISE_FUNCTION slide_along
