// The README's example: a ball falls on a floor.
#include <iostream>

#include "first_contact/first_contact.hpp"

int main() {
  using namespace first_contact;
  const Moving ball{Sphere{Point(0, 0, 3), 1}, Vector(0, 0, -4)};
  const auto contact = sweep(ball, Plane{{0, 0, 1}, 0});
  if (contact) std::cout << contact->time << '\n';  // 0.5
  return contact && contact->time == 0.5 ? 0 : 1;
}
