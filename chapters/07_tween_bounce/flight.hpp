#pragma once
#include <optional>
#include <string>
#include <vector>

#include "first_contact/motion/bounce.hpp"
#include "first_contact/motion/tween.hpp"
#include "printed_bounce.hpp"

/// What this chapter's programs do with a bouncing ball: its flight in samples, and the paper's plan of it.
namespace tween_bounce {

/// A flight, sampled, whichever model it comes from.
struct Flight {
  std::vector<double> t, y;
  std::vector<first_contact::Landing> impacts;
  std::vector<first_contact::Apex> apexes;
  std::optional<double> rest_time;
};

/// The flight as the paper's programs compute it.
Flight printed_flight(const first_contact::PrintedMotion& motion);
/// The flight that is solved at its impacts, at the same times.
Flight physical_flight(const first_contact::Bounce& bounce, double dt, std::size_t samples);

/// The height at any time, straight between two samples.
double height_at(const Flight& flight, double time);

/// Program 1's plan as a tween in the plane of t and y: a straight line down to the first hit, a curve to the
/// second, a straight line along the floor. Nothing if the flight has no fall, rebound and floor.
std::optional<first_contact::Tween> plan(const Flight& flight);

/// Program 2's test: how far the ball is off the planned path, at the worst sample of each of its legs.
std::vector<double> off_plan(const Flight& flight, const first_contact::Tween& tween);

/// When a ball of radius 1 that follows a leg of the plan meets the obstacle, whose top is at -1.
std::optional<double> meets_obstacle(const first_contact::Tween& tween, std::size_t leg);

/// A Bezier curve like any that an animator draws: its parameter is no distance.
first_contact::Bezier arch();

/// The columns t,y.
std::string csv(const Flight& flight);

}  // namespace tween_bounce
