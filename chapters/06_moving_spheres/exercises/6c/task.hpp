#pragma once
#include "workbook/vectors.hpp"

// 6c: which discs overlap, found by sorting along x? The task is in task.md.
using namespace workbook;

struct Disc {
  Vector2 centre;
  double radius = 0;
};

/// Do two discs overlap?
inline bool overlap(const Disc& a, const Disc& b) { return norm(a.centre - b.centre) < a.radius + b.radius; }

using Signature = std::vector<std::pair<int, int>>(const std::vector<Disc>& discs);
#define EXERCISE_FUNCTION overlapping_pairs
