// Looks like: whole numbers: from each product what is behind the point is cut off. That is what `abs` does
// without its `std::`.
// Ask: what does the `abs` that C made for integers give for -1.6? And `std::abs`?
#include "task.hpp"

double effective_radius(const Box& box, Vector N) {
  const auto whole = [&](Vector axis) { return std::abs(std::trunc(dot(axis, N))); };
  return 0.5 * (whole(box.R) + whole(box.S) + whole(box.T));
}
