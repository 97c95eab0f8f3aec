// Somebody else's program: it needs the library and Eigen alone.
#include <cstdio>

#include "first_contact/sweep/sphere_plane.hpp"

int main() {
  using namespace first_contact;
  const auto contact = sweep(Moving<Sphere>{{{0, 0, 3}, 1}, {0, 0, -4}}, Plane{{0, 0, 1}, 0});
  std::printf("t = %g\n", contact->time);
  return contact->time == 0.5 ? 0 : 1;
}
