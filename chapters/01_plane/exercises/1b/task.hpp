#pragma once
#include "workbook/vectors.hpp"

// 1b: a plane has two sides, and a ball may overlap it. The task is in task.md.
using namespace workbook;

using Signature = std::optional<double>(Plane E, Point S0, Vector V, double r);
#define EXERCISE_FUNCTION first_contact
