// Chapter 4: a ball comes from afar at a vertex: the root as multiplied out, and by the closest approach, in floats and doubles.
#include "04_general_sphere/from_afar.hpp"

#include <cmath>
#include <optional>

#include "page.hpp"

using namespace first_contact;
using namespace general_sphere_chapter;
using touch::tell;

namespace {

void tell_entered(const std::string& kind, const Entered& entered, const FromAfar& shot) {
  const auto tell_time = [&](const std::string& name, const std::optional<double>& time) {
    if (!time) return;
    tell("afar/" + kind + "/" + name, *time);
    tell("drawn/" + kind + "/" + name, Vector(shot.from + *time * shot.way));
  };
  tell("afar/" + kind + "/minus_b", entered.minus_b);
  if (!std::isnan(entered.root)) tell("afar/" + kind + "/root", entered.root);
  tell_time("textbook", entered.textbook);
  tell_time("stable", entered.stable);
}

}  // namespace

FOR_THE_PAGE(from_afar)(double distance, double beside) {
  const FromAfar shot = from_afar(distance, beside);
  tell_entered("float", shot.in_float, shot);
  tell_entered("double", shot.in_double, shot);
  tell("drawn/beside", beside);
  const std::optional<double> printed = shot.in_float.textbook, right = shot.in_double.stable;
  if (printed && right) tell("drawn/apart", std::abs(*printed - *right) * shot.way.norm());
}
