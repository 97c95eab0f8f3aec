// Chapter 7: a film of three keys. Its path is tested against a floor and a box before it is played.
#include <algorithm>
#include <string>
#include <vector>

#include "first_contact/motion/css_easing.hpp"
#include "first_contact/motion/play.hpp"
#include "first_contact/sweep/sphere_box.hpp"
#include "first_contact/sweep/sphere_plane.hpp"
#include "page.hpp"

using namespace first_contact;
using touch::tell;

namespace {

constexpr int most_contacts = 64;  // as a film has them

Played play_film(const Tween& plan, double radius, const Box& box, double restitution) {
  const Plane floor({0, 0, 1}, 0);
  const auto meets = [&](const Moving<Sphere>& moving) {
    auto contact = sweep(moving, floor), other = sweep(moving, box);
    return other && (!contact || other->time < contact->time) ? other : contact;
  };
  const double largest = std::max(largest_coordinate(floor), largest_coordinate(box));
  return play(plan, radius, meets, largest, After::bounce(restitution), most_contacts);
}

void tell_contacts(const std::vector<Contact>& contacts, double until) {
  for (std::size_t i = 0; i < contacts.size() && contacts[i].time <= until; ++i) {
    const std::string place = "contacts/" + std::to_string(i);
    tell(place + "/time", contacts[i].time);
    tell(place + "/point", contacts[i].point());
    tell(place + "/normal", contacts[i].normal);
    tell(place + "/feature", to_string(contacts[i].feature));
  }
}

void tell_ways(const Played& played, double end) {
  constexpr int pictures = 150;
  std::vector<double> plan, way;
  for (int i = 0; i <= pictures; ++i) {
    const double time = end * i / pictures;
    const Point planned = played.tween().at(time), made = played.at(time);
    plan.insert(plan.end(), {planned.x(), planned.z()});
    way.insert(way.end(), {made.x(), made.z()});
  }
  tell("drawn/plan", plan);
  tell("drawn/way", way);
}

void tell_easing(const char* name, const Easing& easing) {
  std::vector<double> parts;
  for (int i = 0; i <= 40; ++i) parts.push_back(easing(i / 40.0));
  tell(name, parts);
}

}  // namespace

FOR_THE_PAGE(film)
(double radius, double x0, double z0, double x1, double z1, double x2, double z2, double key_time, double end,
 double a0, double b0, double a1, double b1, double c0, double d0, double c1, double d1, double box_x,
 double box_z, double side, double depth, double restitution, double time) {
  const Easing first = ease::cubic_bezier(a0, b0, a1, b1), second = ease::cubic_bezier(c0, d0, c1, d1);
  const Tween plan({{0, {x0, 0, z0}, first}, {key_time, {x1, 0, z1}, second}, {end, {x2, 0, z2}}});
  const Box box({box_x, 0, box_z}, {side, 0, 0}, {0, depth, 0}, {0, 0, side});
  const Played played = play_film(plan, radius, box, restitution);
  tell_contacts(played.contacts(), time);
  tell("last/place", played.at(time));
  tell("last/time", time);
  tell_ways(played, end);
  tell_easing("drawn/easings/0", first);
  tell_easing("drawn/easings/1", second);
}
