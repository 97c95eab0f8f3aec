#pragma once
#include "workbook/vectors.hpp"

// 4b: when does a ball touch an edge between its ends? The task is in task.md.
using namespace workbook;

using Signature = std::optional<double>(Point a, Point b, Point S0, Vector V, double r);
#define EXERCISE_FUNCTION touch_edge
