#include "flight.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "first_contact/motion/sweep_along.hpp"
#include "first_contact/sweep/sphere_plane.hpp"

using namespace first_contact;

namespace tween_bounce {

Flight printed_flight(const PrintedMotion& motion) {
  Flight flight{motion.t, motion.y, {}, apexes(motion), rest_time(motion)};
  for (const PrintedHit& hit : motion.hits) flight.impacts.push_back({hit.time, hit.speed});
  return flight;
}

Flight physical_flight(const Bounce& bounce, double dt, std::size_t samples) {
  Flight flight;
  for (std::size_t i = 0; i < samples; ++i) {
    flight.t.push_back(static_cast<double>(i) * dt);
    flight.y.push_back(bounce.height(flight.t.back()));
  }
  flight.impacts = bounce.impacts(flight.t.back(), samples);
  flight.apexes = bounce.apexes(flight.t.back(), samples);
  flight.rest_time = bounce.rest_time();
  return flight;
}

double height_at(const Flight& flight, double time) {
  const auto next = std::upper_bound(flight.t.begin(), flight.t.end(), time);
  if (next == flight.t.begin()) return flight.y.front();
  if (next == flight.t.end()) return flight.y.back();
  const auto i = static_cast<std::size_t>(next - flight.t.begin());
  return std::lerp(flight.y[i - 1], flight.y[i], (time - flight.t[i - 1]) / (flight.t[i] - flight.t[i - 1]));
}

//! [plan]
std::optional<Tween> plan(const Flight& flight) {
  if (flight.impacts.size() < 2) return std::nullopt;
  const double first = flight.impacts[0].time, second = flight.impacts[1].time;
  const auto top = std::find_if(flight.apexes.begin(), flight.apexes.end(),
                                [&](const Apex& apex) { return apex.time > first && apex.time < second; });
  if (!(first > 0) || top == flight.apexes.end() || !(second < flight.t.back())) return std::nullopt;
  const Point pull(0.5 * (first + second), 2 * top->height, 0);  // a parabola's control point: twice as high
  return Tween({{0, {0, flight.y.front(), 0}},
                {first, {first, 0, 0}, ease::linear, Path::bezier({pull})},
                {second, {second, 0, 0}},
                {flight.t.back(), {flight.t.back(), 0, 0}}});
}

std::vector<double> off_plan(const Flight& flight, const Tween& tween) {
  const auto& keys = tween.keys();
  std::vector<double> worst(keys.size() - 1, 0.0);
  for (std::size_t i = 0; i < flight.t.size(); ++i) {
    std::size_t leg = 0;
    while (leg + 2 < keys.size() && flight.t[i] > keys[leg + 1].time) ++leg;
    worst[leg] = std::max(worst[leg], std::abs(flight.y[i] - tween.at(flight.t[i]).y()));
  }
  return worst;
}

std::optional<double> meets_obstacle(const Tween& tween, std::size_t leg) {
  const Plane top({0, 1, 0}, 1);  // y = -1: the centre of a ball of radius 1 meets it at y = 0
  const auto touch = sweep_along(tween.curve(leg), 1, top, 1e-6);
  if (!touch) return std::nullopt;
  return std::lerp(tween.keys()[leg].time, tween.keys()[leg + 1].time, touch->time);
}
//! [plan]

Bezier arch() { return Bezier({{0, 0, 0}, {0.5, 4, 0}, {2, 4, 0}, {8, 0, 0}}); }

std::string csv(const Flight& flight) {
  std::string text = "t,y\n";
  char row[64];
  for (std::size_t i = 0; i < flight.t.size(); ++i) {
    std::snprintf(row, sizeof row, "%.17g,%.17g\n", flight.t[i], flight.y[i]);
    text += row;
  }
  return text;
}

}  // namespace tween_bounce
