#pragma once
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <random>
#include <vector>

#include "first_contact/geometry/sphere.hpp"
#include "first_contact/sweep/contact.hpp"

/// Scenes of moving spheres, and what is counted beside the times; shared by the programs that measure.
namespace pairs {

using Balls = std::vector<first_contact::Moving<first_contact::Sphere>>;

inline first_contact::Vector vector(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> uniform(-size, size);
  const double x = uniform(random), y = uniform(random), z = uniform(random);
  return {x, y, z};
}

/// Spheres in a cube of that side, radii from 0.1 to the largest, motions of up to `reach` along each axis.
inline Balls balls(std::size_t count, unsigned seed, double side = 6, double largest = 1, double reach = 4) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> radius(0.1, largest);
  Balls all;
  all.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const first_contact::Point center = vector(random, side / 2);
    all.push_back({{center, radius(random)}, vector(random, reach)});
  }
  return all;
}

/// As many as wished, at one density: radii from 0.1 to 0.3, motions of up to 1, one sphere in a cube of side
/// 1.
inline Balls crowd(std::size_t count) {
  return balls(count, 1, std::cbrt(static_cast<double>(count)), 0.3, 1);
}

/// The first contact in extended precision, by the closest approach.
struct Truth {
  long double time = std::numeric_limits<long double>::infinity();  ///< infinite if there is none
  bool grazing = false;  ///< P goes less than a hundredth of the radii inside: the time is ill conditioned
};

inline Truth truth(const first_contact::Moving<first_contact::Sphere>& p,
                   const first_contact::Moving<first_contact::Sphere>& q) {
  using Long = Eigen::Matrix<long double, 3, 1>;
  const Long w = p.shape.center.cast<long double>() - q.shape.center.cast<long double>();
  const Long u = p.displacement.cast<long double>() - q.displacement.cast<long double>();
  const long double d = static_cast<long double>(p.shape.radius) + q.shape.radius;
  const long double a = u.squaredNorm(), b = w.dot(u), c = w.squaredNorm() - d * d;
  if (!(b < 0)) return {};
  if (c <= 0) return {0};
  const long double D = a * (d * d) - w.cross(u).squaredNorm();
  if (!(D >= 0)) return {};
  const long double t = c / (-b + std::sqrt(D));
  return t <= 1 ? Truth{t, D < 1e-4L * a * d * d} : Truth{};
}

/// Misses, false hits and the largest error of a time that is no graze, against extended precision.
struct Errors {
  double missed = 0, imagined = 0, largest = 0;

  void count(double time, const Truth& right) {
    if (right.time <= 1 && !(time <= 1)) ++missed;
    if (!(right.time <= 1) && time <= 1) ++imagined;
    if (right.time <= 1 && time <= 1 && !right.grazing)
      largest = std::max(largest, static_cast<double>(std::abs(time - right.time)));
  }
  void tell(benchmark::State& state) const {
    state.counters["missed"] = missed;
    state.counters["imagined"] = imagined;
    state.counters["error_1e-15"] = largest * 1e15;
  }
};

/// Counts the errors of the times of p[i] and q[i], and tells them.
inline void tell_errors(benchmark::State& state, const std::vector<double>& times, const Balls& p,
                        const Balls& q) {
  Errors errors;
  for (std::size_t i = 0; i < times.size(); ++i) errors.count(times[i], truth(p[i], q[i]));
  errors.tell(state);
}

/// Time of the processor, not of the clock on the wall, in nanoseconds.
inline double now() {
  timespec time;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
}

/// The middle one.
inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Runs it as often as the state wishes. \returns the median of its times, in nanoseconds
template <class Run>
double measure(benchmark::State& state, const Run& run) {
  std::vector<double> times;
  for (auto _ : state) {
    const double start = now();
    run();
    times.push_back(now() - start);
    state.SetIterationTime(times.back() * 1e-9);
  }
  return median(times);
}

}  // namespace pairs
