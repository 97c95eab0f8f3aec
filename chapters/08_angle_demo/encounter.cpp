#include "encounter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "first_contact/geometry/refuse.hpp"

using namespace first_contact;
using Eigen::Vector2d;

namespace {

double direction(const Vector2d& v) { return to_degrees(std::atan2(v.y(), v.x())); }

Vector lifted(const Vector2d& v) { return {v.x(), v.y(), 0}; }

}  // namespace

std::array<Encounter, 4> paper_cases() {
  const Encounter first;
  Encounter second = first, third = first, fourth = first;
  second.mass = third.mass = {1, 1};
  third.v1 = third.v2 = {0, 1};
  fourth.p1 = {-1, 8};
  fourth.p2 = {0.5, -23};
  fourth.v1 = {3, -1};
  fourth.v2 = {-1, 2};
  return {first, second, third, fourth};
}

std::array<Moving<Sphere>, 2> in_space(const Encounter& e) {
  return {Moving<Sphere>{{lifted(e.p1), e.radius}, lifted(e.v1)},
          Moving<Sphere>{{lifted(e.p2), e.radius}, lifted(e.v2)}};
}

Outcome as_printed(const Encounter& e) {
  const auto after = printed_impact({e.mass[0], e.p1, e.v1}, {e.mass[1], e.p2, e.v2}, e.restitution);
  return {after.collides, std::nullopt, after.velocity, after.angle};
}

//! [at_contact]
Outcome at_contact(const Encounter& e) {
  const auto [p, q] = in_space(e);
  const auto contact = sweep(p, q, {0, std::numeric_limits<double>::max()});
  if (!contact) return {false, std::nullopt, {e.v1, e.v2}, {direction(e.v1), direction(e.v2)}};
  const Vector2d normal = contact->normal.head<2>();
  const auto after = impact<2>({e.mass[0], e.v1}, {e.mass[1], e.v2}, normal, e.restitution);
  return {true,
          contact->time,
          {after.velocity_p, after.velocity_q},
          {direction(after.velocity_p), direction(after.velocity_q)}};
}
//! [at_contact]

Closest closest_approach(const Encounter& e) {
  const Vector2d w = e.p1 - e.p2, u = e.v1 - e.v2;
  const double time = u.squaredNorm() > 0 ? std::max(0.0, -w.dot(u) / u.squaredNorm()) : 0.0;
  const Vector2d apart = w + time * u;
  return {time, norm(Vector(apart.x(), apart.y(), 0))};
}

std::array<Vector2d, 2> centres(const Encounter& e, double time) {
  return {e.p1 + time * e.v1, e.p2 + time * e.v2};
}

double energy(const Encounter& e, const std::array<Vector2d, 2>& v) {
  double sum = 0;
  for (const std::size_t i : {0U, 1U}) {
    const double mass = e.mass[static_cast<int>(i)];
    if (std::isfinite(mass)) sum += mass * v[i].squaredNorm() / 2;
  }
  if (!std::isfinite(sum)) refuse("energy", "must not lead beyond the range of numbers");
  return sum;
}

Vector2d momentum(const Encounter& e, const std::array<Vector2d, 2>& v) {
  return e.mass[0] * v[0] + e.mass[1] * v[1];
}

Encounter aimed_beside() {
  Encounter aimed;
  aimed.mass = {1, 1};
  aimed.p1 = {-5, 1};
  aimed.p2 = {0, 0};
  aimed.v1 = {5, 0};
  aimed.v2 = {0, 0};
  return aimed;
}

Encounter soft_and_aslant() {
  Encounter soft;
  soft.mass = {1, 1};
  soft.p1 = {-1, 0};
  soft.p2 = {1, 0};
  soft.v2 = {-1, -1};
  soft.restitution = 0.5;
  return soft;
}
