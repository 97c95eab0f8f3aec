// Chapter 5: a ball slides along the ground and a second wall; the ways that it might go, and wall after wall.
#include "05_slide/jitter.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "page.hpp"

using namespace first_contact;
using touch::tell;

namespace {

std::string place_of(const char* list, std::size_t i, const char* what = "") {
  return std::string(list) + "/" + std::to_string(i) + what;
}

void tell_path(const Slide& path) {
  for (std::size_t i = 0; i < path.positions.size(); ++i) tell(place_of("positions", i), path.positions[i]);
  for (std::size_t i = 0; i < path.contacts.size(); ++i) {
    tell(place_of("contacts", i, "/time"), path.contacts[i].time);
    tell(place_of("contacts", i, "/point"), path.contacts[i].point());
    tell(place_of("contacts", i, "/normal"), path.contacts[i].normal);
  }
  tell("end", path.end());
}

// At each contact, where what is left of the wish would lead along each of the walls that have been met.
void tell_ways(const Slide& path, const Moving<Sphere>& ball) {
  std::size_t way = 0;
  for (std::size_t i = 0; i < path.contacts.size(); ++i) {
    const Point& at = path.positions[std::min(i + 1, path.positions.size() - 1)];
    const Point wished = at + (1 - path.contacts[i].time) * ball.displacement;
    for (std::size_t j = 0; j <= i; ++j, ++way) {
      tell(place_of("drawn/ways", way, "/from"), at);
      tell(place_of("drawn/ways", way, "/to"), slide_target(wished, at, path.contacts[j].normal));
    }
  }
}

}  // namespace

FOR_THE_PAGE(slide)
(double x1, double z1, double x2, double z2, double wall_x, double wall_z, double radius) {
  const Environment room(walls(ground_with_wall({wall_x, 0, wall_z})));
  const Point from{x1, 0, z1}, to{x2, 0, z2};
  const Moving<Sphere> ball{{from, radius}, to - from};
  const Slide path = slide(ball, room);
  tell_path(path);
  tell_ways(path, ball);
  tell("wall_after_wall", wall_after_wall(ball, room));
  touch::tell_whether("drawn/arrived", path.ending == Ending::arrived);
}
