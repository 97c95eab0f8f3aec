#pragma once
#include "workbook/vectors.hpp"

// 1c: is it certain that nothing was touched? The task is in task.md.
using namespace workbook;

using Signature = bool(Plane E, double r, Point S0, Point S1);
#define EXERCISE_FUNCTION surely_free
