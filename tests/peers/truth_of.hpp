#pragma once
#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "first_contact/trees/plain_bvh.hpp"
#include "peers/ways.hpp"
#include "verify/truth.hpp"

/// \file
/// What is true of a cast, for counting what ways miss and how wrong their times are.

namespace peers {

/// Does the cast certainly touch, and if so, when? Casts that overlap at the start are not judged: engines
/// differ about them on purpose.
struct Truth {
  bool judged = false, certain = false, possible = false;
  double time = never;
};

inline Truth truth_of(const Moving<Sphere>& moving, const PlainBvh& tree) {
  using Real = long double;
  const Real r = moving.shape.radius, graze = 1e-12L;  // of r
  std::optional<Real> time, early, late;
  const auto keep = [](std::optional<Real>& first, const std::optional<Real>& other) {
    if (other && (!first || *other < *first)) first = other;
  };
  tree.visit(moving, [&](std::uint32_t triangle) {
    const truth::Approach<Real> approach(tree.mesh().triangle(triangle), moving.shape.center,
                                         moving.displacement);
    keep(early, approach.first_time(r * (1 + graze)));
    if (early) keep(time, approach.first_time(r));
    if (time) keep(late, approach.first_time(r * (1 - graze)));
    return late ? static_cast<double>(*late) * (1 + 1e-9) + 1e-15 : 1.0;
  });
  Truth truth{!(early && *early == 0), late.has_value(), early.has_value(), never};
  if (time) truth.time = static_cast<double>(*time);
  return truth;
}

/// What a way's answers are worth.
struct Worth {
  std::size_t judged = 0, missed = 0, false_hits = 0;
  std::vector<double> errors = {};
  void add(const Truth& truth, double time) {
    if (!truth.judged) return;
    ++judged;
    missed += truth.certain && time == never;
    false_hits += !truth.possible && time != never;
    if (truth.time != never && time != never) errors.push_back(std::abs(time - truth.time));
  }
  double median_error() {
    if (errors.empty()) return 0;
    std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2),
                     errors.end());
    return errors[errors.size() / 2];
  }
  double worst_error() const { return errors.empty() ? 0 : *std::max_element(errors.begin(), errors.end()); }
};

}  // namespace peers
