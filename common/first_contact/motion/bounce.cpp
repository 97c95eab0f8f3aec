#include "first_contact/motion/bounce.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "first_contact/geometry/refuse.hpp"
#include "first_contact/geometry/space.hpp"

namespace first_contact {

namespace {

void require_time(double time, const std::string& of) {
  if (!std::isfinite(time)) refuse("bounce's time of " + of, time, "must be finite");
}

//! [geometric_sum]
// 1 + e + e^2 + ... (m terms) = (1 - e^m) / (1 - e), by expm1: near e = 1 both differences cancel.
double geometric_sum(double e, std::size_t m) {
  if (e == 0) return m > 0 ? 1 : 0;
  const auto terms = static_cast<double>(m);
  return e == 1 ? terms : std::expm1(terms * std::log(e)) / (e - 1);
}
//! [geometric_sum]

//! [first_landing]
// The first root of h - v t - g t^2 / 2 = 0. Energy gives the speed there; the time follows by the form of
// the root that does not cancel.
std::optional<Landing> first_landing(double h, double v, double g) {
  const double speed = norm({v, std::sqrt(2 * g) * std::sqrt(h), 0});
  if (speed == 0) return std::nullopt;                     // at rest, on the floor or without gravity
  if (v >= 0) return Landing{2 * h / (v + speed), speed};  // thrown down, or dropped
  if (g == 0) return std::nullopt;                         // thrown up, and nothing brings it back
  return Landing{(speed - v) / g, speed};                  // thrown up
}
//! [first_landing]

}  // namespace

Bounce::Bounce(double height, double speed_down, double gravity, double restitution)
    : height_(height), speed_down_(speed_down), gravity_(gravity), restitution_(restitution) {
  require_length(height, "bounce's height");
  if (!(std::abs(speed_down) <= largest_length))
    refuse("bounce's speed", speed_down, "must be finite, and at most 1.07e301 (2^1000)");
  require_length(gravity, "bounce's gravity");
  if (!(restitution >= 0 && restitution <= 1))
    refuse("bounce's restitution", restitution, "must be from 0 to 1");
  first_ = first_landing(height, speed_down, gravity);
  for (const std::size_t n : {0U, 1U})
    if (const auto top = apex(n); top && !(top->height <= 2 * largest_length))
      refuse("height that the bounce reaches", top->height, "must be at most 2.1e301 (2^1001)");
  if (first_) require_time(first_->time, "first impact");
  if (const auto rest = rest_time()) require_time(*rest, "rest");
}

//! [zeno]
double Bounce::impact_speed(std::size_t n) const {
  return first_->speed * std::pow(restitution_, static_cast<double>(n - 1));  // v1 e^(n - 1)
}

// The flight between the first impact and the second: up with e v1, and down again. Each later one is e times
// as long.
double Bounce::first_rebound() const { return 2 * restitution_ * first_->speed / gravity_; }

double Bounce::impact_time(std::size_t n) const {
  return n == 1 ? first_->time : first_->time + first_rebound() * geometric_sum(restitution_, n - 1);
}

std::optional<double> Bounce::rest_time() const {
  if (!first_) return height_ == 0 && speed_down_ == 0 ? std::optional(0.0) : std::nullopt;
  if (restitution_ == 0) return first_->time;
  if (restitution_ == 1 || gravity_ == 0) return std::nullopt;
  return first_->time + first_rebound() / (1 - restitution_);  // all the terms of the sum
}
//! [zeno]

std::optional<Landing> Bounce::impact(std::size_t n) const {
  if (!first_ || n == 0) return std::nullopt;
  if (n > 1 && (restitution_ == 0 || gravity_ == 0)) return std::nullopt;
  const double time = impact_time(n);
  return std::isfinite(time) ? std::optional(Landing{time, impact_speed(n)}) : std::nullopt;
}

std::optional<Apex> Bounce::apex(std::size_t n) const {
  if (gravity_ == 0) return std::nullopt;
  const auto top = [&](double time, double height, double up) {
    return Apex{time + up / gravity_, height + up / gravity_ * up / 2};
  };
  if (n == 0) return speed_down_ < 0 ? std::optional(top(0, height_, -speed_down_)) : std::nullopt;
  const auto landing = impact(n);
  if (!landing || restitution_ == 0) return std::nullopt;
  return top(landing->time, 0, restitution_ * landing->speed);
}

std::vector<Landing> Bounce::impacts(double until, std::size_t most) const {
  std::vector<Landing> list;
  while (list.size() < most) {
    const auto next = impact(list.size() + 1);
    if (!next || !(next->time <= until)) break;
    if (!list.empty() && !(next->time > list.back().time)) break;  // too close to rest_time() to tell
    list.push_back(*next);
  }
  return list;
}

std::vector<Apex> Bounce::apexes(double until, std::size_t most) const {
  std::vector<Apex> list;
  if (const auto first = apex(0); first && first->time <= until && most > 0) list.push_back(*first);
  for (std::size_t n = 1; list.size() < most; ++n) {
    const auto next = apex(n);
    if (!next || !(next->time <= until) || (!list.empty() && !(next->time > list.back().time))) break;
    list.push_back(*next);
  }
  return list;
}

// How many impacts there are up to a time before rest_time(), by bisection over the closed form.
std::size_t Bounce::impacts_until(double time) const {
  if (!first_ || time < first_->time) return 0;
  if (gravity_ == 0) return 1;
  std::size_t low = 1, high = 2;
  while (impact_time(high) <= time && high < std::numeric_limits<std::size_t>::max() / 4)
    low = std::exchange(high, 2 * high);
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (impact_time(middle) <= time ? low : high) = middle;
  }
  return low;
}

//! [bounce_height]
Bounce::Arc Bounce::arc(double time) const {
  if (!std::isfinite(time)) refuse("time", time, "must be finite");
  const double now = std::max(0.0, time);
  if (const auto rest = rest_time(); rest && now >= *rest) return {0, 0, 0};
  const std::size_t n = impacts_until(now);
  if (n == 0) return {height_, -speed_down_, now};
  const double up = restitution_ * impact_speed(n), since = now - impact_time(n);
  return {0, up, gravity_ > 0 ? std::min(since, 2 * up / gravity_) : since};
}

double Bounce::height(double time) const {
  const auto [start, up, s] = arc(time);
  return std::max(0.0, start + s * (up - gravity_ / 2 * s));
}
//! [bounce_height]

double Bounce::speed_down(double time) const {
  const auto [start, up, s] = arc(time);
  return gravity_ * s - up;
}

}  // namespace first_contact
