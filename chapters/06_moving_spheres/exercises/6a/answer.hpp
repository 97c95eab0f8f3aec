#include "task.hpp"

// The first contact in [from, to] of two balls whose radii are d together, at P + tVp and Q + tVq; else {}.
std::optional<double> first_contact(Point P, Vector Vp, Point Q, Vector Vq, double d, double from,
                                    double to) {
  return {};
}
