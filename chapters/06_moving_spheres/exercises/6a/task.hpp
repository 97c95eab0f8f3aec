#pragma once
#include "workbook/vectors.hpp"

// 6a: when do two moving balls first touch, within a span of time? The task is in task.md.
using namespace workbook;

using Signature = std::optional<double>(Point P, Vector Vp, Point Q, Vector Vq, double d, double from,
                                        double to);
#define EXERCISE_FUNCTION first_contact
