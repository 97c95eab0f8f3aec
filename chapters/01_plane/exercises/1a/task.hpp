#pragma once
#include "workbook/vectors.hpp"

// 1a: when does a ball first touch a plane? The task is in task.md.
using namespace workbook;

using Signature = std::optional<double>(Plane E, Point S0, Vector V, double r);
#define EXERCISE_FUNCTION touch_time
