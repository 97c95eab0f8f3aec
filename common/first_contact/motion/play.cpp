#include "first_contact/motion/play.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "first_contact/geometry/products.hpp"
#include "first_contact/motion/keys.hpp"

namespace first_contact {

namespace {

// The direction of the tween's motion at a time between two keys, before it is bent; zero where it stands still.
Vector direction_at(const Tween& tween, double time) {
  const std::size_t last = tween.legs().size() - 1, i = std::min(keys::current(tween.keys(), time), last);
  const Leg& leg = tween.legs()[i];
  const double begin = tween.keys()[i].time, end = tween.keys()[i + 1].time;
  const Timing timing(tween.keys()[i].easing, begin, end);
  const Interval all(begin, end);
  const std::vector<OneWay> ways = timing.ways(all);
  const auto now =
      std::find_if(ways.begin(), ways.end(), [&](const OneWay& way) { return time < way.to_time; });
  const OneWay& way = now != ways.end() ? *now : ways.back();
  const double place = leg.parameter(timing.part_at(time));
  // Beyond its ends a path at constant speed goes straight on, and another one as it bends.
  const double u = leg.by_length() ? std::clamp(place, 0.0, 1.0) : place;
  const Vector forwards = normalized(first_contact::at(derivative(leg.curve()), u));
  return way.from_part <= way.to_part ? forwards : Vector(-forwards);
}

// Where the sphere is at a contact: where the tween is, unless it jumps at that time, past the place of the contact,
// or is so fast that a rounding of the time leads beside it.
Point place_of_contact(const Contact& contact, double radius, double largest_coordinate,
                       const Point& on_tween) {
  const Point touching = contact.point() + radius * contact.normal;
  const double size =
      std::max({largest_coordinate, radius, touching.cwiseAbs().maxCoeff(), on_tween.cwiseAbs().maxCoeff()});
  return norm(touching - on_tween) <= 4 * tween_gap * size ? on_tween : touching;
}

}  // namespace

Eigen::Matrix3d After::map(const Vector& motion, const Vector& normal) const {
  return kind_ == Kind::stop ? Eigen::Matrix3d::Zero() : rebound(motion, normal, surface_);
}

Point Played::at(double time) const {
  const Point place = tween_.at(time);
  const auto next =
      std::find_if(contacts_.begin(), contacts_.end(), [&](const Contact& c) { return c.time > time; });
  if (next == contacts_.begin()) return place;
  const auto last = static_cast<std::size_t>(next - contacts_.begin()) - 1;
  if (contacts_[last].time == time) return places_[last];
  const Bend& bend = bends_[last];
  return product(bend.linear, place) + bend.shift;
}

//! [turn_aside]
void Played::turn_aside(const Contact& contact, const Point& here, const After& after) {
  const Bend before = bend();
  const Vector motion = product(before.linear, direction_at(tween_, contact.time));
  const Eigen::Matrix3d map = after.map(motion, contact.normal);
  const Vector from_here = before.shift - here;
  bends_.push_back({product(map, before.linear), here + product(map, from_here)});
  contacts_.push_back(contact);
  places_.push_back(here);
}
//! [turn_aside]

// After a contact within a jump the sphere goes straight on to where the jump then leads, unless something is in the way:
// there it stops. \returns the time after the jump
double finish_jump(Played& played, double radius, const SphereSweep& first_contact_of) {
  const double time = std::nextafter(played.contacts().back().time, std::numeric_limits<double>::infinity());
  const Point from = played.at(played.contacts().back().time), to = played.at(time);
  if (auto contact = first_contact_of({{from, radius}, to - from})) {
    const Point here = from + contact->time * (to - from);
    contact->time = time;
    played.turn_aside(*contact, here, After::stop());
  }
  return time;
}

//! [play]
Played play(const Tween& tween, double radius, const SphereSweep& first_contact_of, double largest_coordinate,
            const After& after, int most_contacts) {
  Played played(tween);
  double time = tween.begin();
  while (const auto contact = sweep(tween, radius, first_contact_of, largest_coordinate,
                                    Interval(time, tween.end()), played.bend())) {
    const bool last = std::ssize(played.contacts()) + 1 >= most_contacts;
    const Bend bend = played.bend();
    const Point on_tween = product(bend.linear, tween.at(contact->time)) + bend.shift;
    const Point here = place_of_contact(*contact, radius, largest_coordinate, on_tween);
    played.turn_aside(*contact, here, last ? After::stop() : after);
    time = here == on_tween ? contact->time : finish_jump(played, radius, first_contact_of);
  }
  return played;
}
//! [play]

}  // namespace first_contact
