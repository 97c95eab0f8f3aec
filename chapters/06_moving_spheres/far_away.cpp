#include "far_away.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "first_contact/program/random.hpp"
#include "first_contact/sweep/contact_times.hpp"

using namespace first_contact;
using program::Accuracy, program::uniform, program::unit_vector;

namespace {

//! [far_away]
// One shot from `distance` away: how far off the contact is, infinite if the formula does not find it;
// nothing if the spheres, rounded to this precision, truly miss each other.
template <class Scalar>
std::optional<double> error_of_one(Formula formula, double distance, std::mt19937& random) {
  constexpr Scalar d = 2;
  const Vector direction = unit_vector(random), across = direction.unitOrthogonal();
  const Vector start = d * (0.9 * uniform(random) * across - distance * direction);
  const Vector3<Scalar> w = start.cast<Scalar>(), u = direction.cast<Scalar>();

  const auto truth =
      contact_times<long double>(w.template cast<long double>(), u.template cast<long double>(), d);
  if (!truth) return std::nullopt;
  const auto times = formula == Formula::textbook ? textbook_times(w, u, d) : contact_times(w, u, d);
  return times ? static_cast<double>(std::abs(times->begin - truth->begin) / d)
               : program::lost_shot;  // u is 1 long
}
//! [far_away]

template <class Scalar>
Accuracy measure_from(Formula formula, double distance, std::mt19937& random) {
  std::vector<double> errors;
  for (int shot = 0; shot < 2000; ++shot)
    if (const auto error = error_of_one<Scalar>(formula, distance, random)) errors.push_back(*error);
  return program::accuracy(distance, std::move(errors));
}

}  // namespace

template <class Scalar>
std::vector<Accuracy> measure(Formula formula) {
  std::mt19937 random(1);
  std::vector<Accuracy> results;
  // Beyond 1 / eps, neighbouring numbers are farther apart than the spheres are wide.
  for (int half_decade = 0; half_decade <= 20; ++half_decade) {
    const double distance = std::pow(10, half_decade / 2.0);
    if (distance * std::numeric_limits<Scalar>::epsilon() > 1) break;
    results.push_back(measure_from<Scalar>(formula, distance, random));
  }
  return results;
}

template std::vector<Accuracy> measure<float>(Formula);
template std::vector<Accuracy> measure<double>(Formula);
