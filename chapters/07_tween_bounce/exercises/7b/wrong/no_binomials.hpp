// Looks like: the powers of t and 1 - t are added without the binomial coefficients: the weights do not sum
// up to 1.
// Ask: how much of the whole is there of three equal points at one half?
#include "task.hpp"

Vector2 bezier(const std::vector<Vector2>& points, double t) {
  Vector2 sum;
  const auto n = static_cast<double>(points.size()) - 1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto k = static_cast<double>(i);
    sum = sum + std::pow(t, k) * std::pow(1 - t, n - k) * points[i];
  }
  return sum;
}
