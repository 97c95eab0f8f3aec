// Many balls that move: which two meet first, and where do they go then?
#include <cstdio>

#include "first_contact/first_contact.hpp"

int main() {
  using namespace first_contact;
  const std::vector<Moving<Sphere>> balls{Moving{Sphere{Point(-3, 0, 0), 1}, Vector(4, 0, 0)},
                                          Moving{Sphere{Point(3, 0, 0), 1}, Vector(-4, 0, 0)},
                                          Moving{Sphere{Point(0, 9, 0), 1}, Vector(0, 1, 0)}};
  const auto met = first_contacts(balls);
  if (met.size() != 1) return 1;
  std::printf("%zu and %zu meet at %g\n", met[0].first, met[0].second, met[0].contact.time);
  return met[0].contact.time == 0.5 ? 0 : 1;
}
