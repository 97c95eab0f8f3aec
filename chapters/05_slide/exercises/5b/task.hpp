#pragma once
#include "workbook/vectors.hpp"

// 5b: which motion is nearest to the wished one along two walls? The task is in task.md.
using namespace workbook;

using Signature = Vector(Vector w, Vector N, Vector M);
#define EXERCISE_FUNCTION along_two_walls
