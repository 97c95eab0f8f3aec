#pragma once
#include "workbook/vectors.hpp"

// 2a: how far does a box reach along a normal? The task is in task.md.
using namespace workbook;

using Signature = double(const Box& box, Vector N);
#define EXERCISE_FUNCTION effective_radius
