// A ball that an animator sends along a curve meets the floor.
#include <cmath>
#include <cstdio>

#include "first_contact/first_contact.hpp"

int main() {
  using namespace first_contact;
  const Bezier dive({{0, 0, 4}, {2, 0, -4}, {4, 0, 4}});  // z = 4 (1 - 2u)^2
  const auto touch = sweep_along(dive, 1, Plane{{0, 0, 1}, 0}, 1e-9);
  if (!touch) return 1;
  std::printf("it touches at u = %.6f, x = %.6f\n", touch->time, touch->point().x());
  return std::abs(touch->time - 0.25) < 1e-9 ? 0 : 1;
}
