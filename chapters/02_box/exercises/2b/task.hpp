#pragma once
#include "workbook/vectors.hpp"

// 2b: which points of a box are lowest: one, two or four? The task is in task.md.
using namespace workbook;

using Signature = std::vector<Point>(const Box& box, Vector N);
#define EXERCISE_FUNCTION lowest_points
