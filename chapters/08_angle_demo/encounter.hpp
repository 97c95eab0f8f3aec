#pragma once
#include <array>
#include <numbers>
#include <optional>

#include "first_contact/response/impact.hpp"
#include "first_contact/sweep/sphere_sphere.hpp"
#include "printed_impact.hpp"

//! [encounter]
/// Two discs of one size, each moving straight on until they meet. The defaults are program 4's first case.
struct Encounter {
  Eigen::Vector2d mass{5, 1};
  Eigen::Vector2d p1{0, 0}, p2{1, 0};
  Eigen::Vector2d v1{1, 1}, v2{-1, 1};
  double restitution = 1, radius = 1;
};

/// The four cases of program 4.
std::array<Encounter, 4> paper_cases();
//! [encounter]

/// What becomes of them, by one model or the other.
struct Outcome {
  bool collides;
  std::optional<double> time;  ///< of the contact; program 4 does not ask
  std::array<Eigen::Vector2d, 2> velocity;
  std::array<double, 2> angle;  ///< of the velocities, in degrees
};

/// As program 4 has it.
Outcome as_printed(const Encounter& encounter);
/// Corrected: they collide only if they meet, at any time from 0 on, and with the normal at contact.
Outcome at_contact(const Encounter& encounter);

/// The discs as spheres in space, for the sweep.
std::array<first_contact::Moving<first_contact::Sphere>, 2> in_space(const Encounter& encounter);

/// When the centres are nearest to each other, from time 0 on, and how far apart they are then.
struct Closest {
  double time, distance;
};
Closest closest_approach(const Encounter& encounter);
/// Where the centres are at a time.
std::array<Eigen::Vector2d, 2> centres(const Encounter& encounter, double time);

/// 1/2 (m1 v1^2 + m2 v2^2); that of a wall does not change, and is left out.
/// \throws std::invalid_argument if it is larger than any number.
double energy(const Encounter& encounter, const std::array<Eigen::Vector2d, 2>& velocity);
/// m1 v1 + m2 v2.
Eigen::Vector2d momentum(const Encounter& encounter, const std::array<Eigen::Vector2d, 2>& velocity);

/// Two unit discs, one at rest, the other aimed one radius beside its centre: they meet at 30 degrees.
Encounter aimed_beside();

/// Two unit discs that touch, each moving aslant, with restitution 1/2: only what is along the line of
/// centres may change.
Encounter soft_and_aslant();
