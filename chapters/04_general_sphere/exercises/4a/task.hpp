#pragma once
#include "workbook/vectors.hpp"

// 4a: when does a point enter a sphere? The task is in task.md.
using namespace workbook;

using Signature = std::optional<double>(Vector m, Vector v, double r);
#define EXERCISE_FUNCTION first_root
