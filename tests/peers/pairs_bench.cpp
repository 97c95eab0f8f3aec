// Moving spheres in batches and in crowds: times, and the errors beside them. A batch is measured against the
// time that the memory alone takes, in turns with it, as other programs may be running.

#include <algorithm>
#include <functional>

#include "first_contact/batch/batch.hpp"
#include "first_contact/pairs/first_contacts.hpp"
#include "first_contact/sweep/box_plane.hpp"
#include "first_contact/sweep/sphere_plane.hpp"
#include "first_contact/sweep/sphere_sphere.hpp"
#include "moving_columns.hpp"
#include "peers/pairs.hpp"

using namespace first_contact;
using pairs::Balls;

namespace {

using Two __attribute__((vector_size(16), aligned(8))) = double;

inline Two two(const double* from) {
  Two value;
  __builtin_memcpy(&value, from, sizeof value);
  return value;
}

/// What the memory takes by itself: reads all columns and writes one, and adds, no more.
template <std::size_t Count, std::size_t... Part>
void memory_floor(const std::array<const double*, Count>& columns, std::vector<double>& result,
                  std::index_sequence<Part...>) {
  const std::array<const double*, Count> from = columns;
  double* const to = result.data();
  for (std::size_t i = 0; i + 4 <= result.size(); i += 4)
    for (std::size_t k = i; k < i + 4; k += 2) {
      const Two sum = (two(from[Part] + k) + ...);
      __builtin_memcpy(to + k, &sum, sizeof sum);
    }
}
template <std::size_t Count>
void memory_floor(const std::array<const double*, Count>& columns, std::vector<double>& result) {
  memory_floor(columns, result, std::make_index_sequence<Count>());
}

template <std::size_t... Part>
std::array<const double*, sizeof...(Part)> all_of(MovingColumns& columns, std::index_sequence<Part...>) {
  return {columns.column(Part).data()...};
}

/// Measures in turns with the floor, and reports nanoseconds for each of `count`, and what part of the
/// floor's they are.
void against_floor(benchmark::State& state, std::size_t count, const std::function<void()>& floor,
                   const std::function<void()>& subject) {
  std::vector<double> floors, subjects;
  const auto n = static_cast<double>(count);
  for (auto _ : state) {
    const double start = pairs::now();
    floor();
    const double middle = pairs::now();
    subject();
    const double end = pairs::now();
    floors.push_back((middle - start) / n);
    subjects.push_back((end - middle) / n);
    state.SetIterationTime((end - middle) * 1e-9);
  }
  state.counters["ns"] = pairs::median(subjects);
  state.counters["floor_ns"] = pairs::median(floors);
  state.counters["of_floor"] = pairs::median(subjects) / pairs::median(floors);
}

void batch_of_spheres(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const Balls p = pairs::balls(count, 1), q = pairs::balls(count, 2);
  MovingColumns p_columns(p), q_columns(q);
  const MovingSpheres p_view = p_columns.spheres(), q_view = q_columns.spheres();
  std::array<const double*, 14> columns;
  const auto seven = std::make_index_sequence<7>();
  std::ranges::copy(all_of(p_columns, seven), columns.begin());
  std::ranges::copy(all_of(q_columns, seven), columns.begin() + 7);
  std::vector<double> times(count), sums(count);
  against_floor(
      state, count, [&] { memory_floor(columns, sums); }, [&] { sweep(p_view, q_view, times); });
  pairs::tell_errors(state, times, p, q);
}
BENCHMARK(batch_of_spheres)->Arg(10'000)->Arg(1'000'000)->UseManualTime()->MinTime(2);

void one_sphere_after_the_other(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const Balls p = pairs::balls(count, 1), q = pairs::balls(count, 2);
  std::vector<double> times(count);
  const double ns = pairs::measure(state, [&] {
    for (std::size_t i = 0; i < count; ++i) {
      const auto contact = sweep(p[i], q[i]);
      times[i] = contact ? contact->time : no_contact;
    }
  });
  state.counters["ns"] = ns / static_cast<double>(count);
  pairs::tell_errors(state, times, p, q);
}
BENCHMARK(one_sphere_after_the_other)->Arg(1'000'000)->UseManualTime()->MinTime(1);

const Plane& slope() {
  static const Plane plane({1, 2, 2}, 0.5);
  return plane;
}

void batch_of_spheres_on_a_plane(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  MovingColumns columns(pairs::balls(count, 1));
  const MovingSpheres view = columns.spheres();
  const auto all = all_of(columns, std::make_index_sequence<7>());
  std::vector<double> times(count), sums(count);
  against_floor(
      state, count, [&] { memory_floor(all, sums); }, [&] { sweep(view, slope(), times); });
}
BENCHMARK(batch_of_spheres_on_a_plane)->Arg(10'000)->Arg(1'000'000)->UseManualTime()->MinTime(1);

void batch_of_boxes_on_a_plane(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  std::mt19937 random(3);
  std::vector<Moving<Box>> boxes;
  boxes.reserve(count);
  for (const auto& ball : pairs::balls(count, 1)) {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(3 * ball.shape.radius, pairs::vector(random, 1).normalized()).toRotationMatrix();
    boxes.push_back({{ball.shape.center, turn.col(0), turn.col(1), turn.col(2)}, ball.displacement});
  }
  MovingColumns columns(boxes);
  const MovingBoxes view = columns.boxes();
  const auto all = all_of(columns, std::make_index_sequence<15>());
  std::vector<double> times(count), sums(count);
  against_floor(
      state, count, [&] { memory_floor(all, sums); }, [&] { sweep(view, slope(), times); });
}
BENCHMARK(batch_of_boxes_on_a_plane)->Arg(10'000)->Arg(1'000'000)->UseManualTime()->MinTime(1);

/// Per sphere, and per sphere and log2 n: the second is what should not grow.
void tell_growth(benchmark::State& state, std::size_t count, double ns) {
  const auto n = static_cast<double>(count);
  state.counters["ns_each"] = ns / n;
  state.counters["ns_by_log"] = ns / (n * std::log2(n));
}

void crowd(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const Balls balls = pairs::crowd(count);
  PairStatistics counted;
  std::size_t contacts = 0;
  tell_growth(state, count,
              pairs::measure(state, [&] { contacts = first_contacts(balls, &counted).size(); }));
  state.counters["sweeps"] = static_cast<double>(counted.sweeps);
  state.counters["contacts"] = static_cast<double>(contacts);
}
BENCHMARK(crowd)->Arg(1'000)->Arg(10'000)->Arg(100'000)->UseManualTime()->Unit(benchmark::kMillisecond);

void crowd_one_by_one(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const Balls balls = pairs::crowd(count);
  std::size_t contacts = 0;
  tell_growth(state, count,
              pairs::measure(state, [&] { contacts = first_contacts_one_by_one(balls).size(); }));
  state.counters["contacts"] = static_cast<double>(contacts);
}
BENCHMARK(crowd_one_by_one)->Arg(1'000)->Arg(10'000)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
