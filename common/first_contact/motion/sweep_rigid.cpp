#include "first_contact/motion/sweep_rigid.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "first_contact/geometry/largest_coordinate.hpp"
#include "first_contact/geometry/unit_scale.hpp"
#include "first_contact/motion/chords.hpp"
#include "first_contact/motion/timing.hpp"
#include "first_contact/sweep/turning_plane.hpp"

namespace first_contact {

namespace {

using TurningSweep = std::function<std::optional<Contact>(const Turning<Mesh>&, const Closeness&)>;

/// The body on one leg.
struct RigidLeg {
  const Mesh& body;
  double reach;  // of the body, from its origin
  Rigid start;   // the pose where the leg begins
  const Leg& leg;
  Turn turn;
  double gap;
  double unit;  // in which the question is asked

  // By how much more than its chord a body at constant speed is off: its angle is the part of the length, whose
  // second derivative is at most |C''| / length.
  double spread() const {
    const double length = leg.by_length() ? leg.by_length()->total() : 0;
    return length > 0 ? 1 + std::abs(turn.angle) * reach / length : 1;
  }
  Turning<Mesh> along(const Chord& chord) const;
};

Turning<Mesh> RigidLeg::along(const Chord& chord) const {
  const double from = leg.part(chord.begin), to = leg.part(chord.end);
  const Rigid turned = Rigid::turned(turn.axis, from * turn.angle);
  std::vector<Point> vertices;
  for (const Point& p : body.vertices())
    vertices.push_back(unit * chord.from + turned.direction(start.direction(unit * p)));
  return {Mesh(std::move(vertices), body.faces()), unit * chord.from, turn.axis, (to - from) * turn.angle,
          unit * chord.to - unit * chord.from};
}

std::optional<Contact> touch_on(const RigidLeg& way, const Stretch& stretch, const TurningSweep& meets) {
  const auto look = [&](const Chord& chord) -> Glance {
    const Turning<Mesh> turning = way.along(chord);
    if (chord.straight_enough) return {meets(turning, {way.unit * (2 * way.gap / 3)}), true};
    const double off = std::max(way.gap / 3, way.spread() * chord.deviation);
    auto contact = meets(turning, {way.unit * (2 * off), true});
    const bool clear = !contact;
    return {std::move(contact), clear};
  };
  return first_along(stretch.curve, stretch.from, stretch.to, way.gap / 3 / way.spread(), look);
}

double reach_of(const Mesh& body) {
  double reach = 0;
  for (const Point& p : body.vertices()) reach = std::max(reach, norm(p));
  return reach;
}

double size_of(const RigidTween& tween, double reach, double largest_coordinate) {
  double size = std::max(reach, largest_coordinate);
  for (const Leg& leg : tween.legs()) size = std::max(size, first_contact::largest_coordinate(leg.curve()));
  return size;
}

// The first contact in a unit of length; its points are brought back.
std::optional<Contact> first(const RigidTween& tween, const Mesh& body, double gap, double unit,
                             const Interval& clock, const TurningSweep& meets) {
  for (std::size_t i = 0; i < tween.legs().size(); ++i) {
    const RigidLeg way{
        body, reach_of(body), tween.at(tween.poses()[i].time), tween.legs()[i], tween.turn(i), gap, unit};
    const Timing timing(tween.poses()[i].easing, tween.poses()[i].time, tween.poses()[i + 1].time);
    for (const OneWay& one_way : timing.ways(clock))
      for (const Stretch& stretch : way.leg.stretches(one_way.from_part, one_way.to_part))
        if (auto contact = touch_on(way, stretch, meets)) {
          contact->time = timing.time_of(way.leg.part(contact->time), one_way);
          contact->points /= unit;
          return contact;
        }
  }
  return std::nullopt;
}

double unit_of(double size) { return is_ordinary(size) ? 1 : unit_scale(size); }

}  // namespace

std::optional<Contact> sweep(const RigidTween& tween, const Mesh& body, const Plane& obstacle,
                             const Interval& clock) {
  const double size = size_of(tween, reach_of(body), largest_coordinate(obstacle)), unit = unit_of(size);
  const Plane in_unit(obstacle.normal(), unit * obstacle.offset());
  return first(
      tween, body, turning_gap * size, unit, clock,
      [&](const Turning<Mesh>& turning, const Closeness& close) { return sweep(turning, in_unit, close); });
}

std::optional<Contact> sweep(const RigidTween& tween, const Mesh& body, const Mesh& obstacle,
                             const Interval& clock) {
  const double size = size_of(tween, reach_of(body), largest_coordinate(obstacle)), unit = unit_of(size);
  const Mesh in_unit = scaled(obstacle, unit);
  return first(
      tween, body, turning_gap * size, unit, clock,
      [&](const Turning<Mesh>& turning, const Closeness& close) { return sweep(turning, in_unit, close); });
}

std::optional<Contact> sweep(const RigidTween& tween, const Mesh& body, const Box& obstacle,
                             const Interval& clock) {
  return sweep(tween, body, surface_of(obstacle), clock);
}

}  // namespace first_contact
