// Chapter 8: two discs meet, as program 4 has it and with the normal at contact.
#include "08_angle_demo/encounter.hpp"
#include "page.hpp"

using namespace first_contact;
using Eigen::Vector2d;
using touch::tell;

namespace {

using Velocities = std::array<Vector2d, 2>;

struct Names {
  const char *collides, *time, *first, *second, *energy, *momentum;
};
constexpr Names before{"", "", "", "", "before/energy", "before/momentum"};
constexpr Names printed{"printed/collides",     "printed/time",   "printed/velocities/0",
                        "printed/velocities/1", "printed/energy", "printed/momentum"};
constexpr Names contact{"contact/collides",     "contact/time",   "contact/velocities/0",
                        "contact/velocities/1", "contact/energy", "contact/momentum"};

void tell_pair(const char* name, const Vector2d& pair) { tell(name, std::span(pair.data(), 2)); }

void tell_balance(const Names& names, const Encounter& encounter, const Velocities& velocity) {
  tell(names.energy, energy(encounter, velocity));
  tell_pair(names.momentum, momentum(encounter, velocity));
}

void tell_outcome(const Names& names, const Encounter& encounter, const Outcome& outcome) {
  touch::tell_whether(names.collides, outcome.collides);
  if (outcome.time) tell(names.time, *outcome.time);
  tell_pair(names.first, outcome.velocity[0]);
  tell_pair(names.second, outcome.velocity[1]);
  tell_balance(names, encounter, outcome.velocity);
}

// Where the discs are at a time; an impact sends them off another way.
Velocities places(const Encounter& e, const Outcome& outcome, double impact, double time) {
  const auto before = centres(e, std::min(time, impact));
  const double after = std::max(0.0, time - impact);
  return {before[0] + after * outcome.velocity[0], before[1] + after * outcome.velocity[1]};
}

void tell_places(const char* first, const char* second, const Velocities& at) {
  tell_pair(first, at[0]);
  tell_pair(second, at[1]);
}

}  // namespace

FOR_THE_PAGE(angle_demo)
(double p1x, double p1y, double v1x, double v1y, double p2x, double p2y, double v2x, double v2y, double m1,
 double m2, double restitution, double radius, double time) {
  const Encounter e{{m1, m2}, {p1x, p1y}, {p2x, p2y}, {v1x, v1y}, {v2x, v2y}, restitution, radius};
  const Outcome wrong = as_printed(e), right = at_contact(e);
  tell_balance(before, e, {e.v1, e.v2});
  tell_outcome(printed, e, wrong);
  tell_outcome(contact, e, right);
  const double impact = right.time.value_or(0);
  tell_places("drawn/met/0", "drawn/met/1", centres(e, impact));
  tell_places("drawn/at/0", "drawn/at/1", places(e, right, impact, time));
  tell_places("drawn/printed/0", "drawn/printed/1", places(e, wrong, 0, time));
}
