#pragma once
#include <algorithm>
#include <optional>
#include <vector>

#include "first_contact/geometry/largest_coordinate.hpp"
#include "first_contact/sweep/sphere_plane.hpp"

/// Several planes as one environment, the simplest that has creases and corners.
struct Room {
  std::vector<first_contact::Plane> walls;
};

inline std::optional<first_contact::Contact> sweep(const first_contact::Moving<first_contact::Sphere>& moving,
                                                   const Room& room) {
  std::optional<first_contact::Contact> first;
  for (const first_contact::Plane& wall : room.walls)
    if (const auto contact = sweep(moving, wall); contact && (!first || contact->time < first->time))
      first = contact;
  return first;
}

inline double largest_coordinate(const Room& room) {
  double largest = 0;
  for (const first_contact::Plane& wall : room.walls) largest = std::max(largest, largest_coordinate(wall));
  return largest;
}
