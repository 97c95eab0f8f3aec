#pragma once
#include "workbook/vectors.hpp"

// 5c: where does a ball stop that keeps a gap? The task is in task.md.
using namespace workbook;

using Signature = double(Plane E, Point S0, Vector V, double r, double gap);
#define EXERCISE_FUNCTION stop_time
