// A ball slides along whatever it meets: here a floor and a wall, as a type of one's own.
#include <algorithm>
#include <cstdio>

#include "first_contact/first_contact.hpp"

namespace game {

struct Corner {
  first_contact::Plane floor{{0, 0, 1}, 0}, wall{{-1, 0, 0}, 5};  // z = 0 and x = 5
};

std::optional<first_contact::Contact> sweep(const first_contact::Moving<first_contact::Sphere>& ball,
                                            const Corner& corner) {
  const auto down = sweep(ball, corner.floor), ahead = sweep(ball, corner.wall);
  return !down || (ahead && ahead->time < down->time) ? ahead : down;
}

double largest_coordinate(const Corner&) { return 5; }

}  // namespace game

int main() {
  using namespace first_contact;
  const Slide path = slide(Moving{Sphere{Point(0, 0, 2), 1}, Vector(8, 1, -4)}, game::Corner{});
  std::printf("it ends at %g, %g, %g after %zu contacts\n", path.end().x(), path.end().y(), path.end().z(),
              path.contacts.size());
  return (path.end() - Point(4, 1, 1)).norm() < 1e-12 ? 0 : 1;
}
