#pragma once
#include <cstdint>
#include <vector>

#include "first_contact/geometry/bounds.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/sweep/contact.hpp"

/// \file
/// Rooms full of objects, and balls that fly through them: the same for a seed on every computer.

/// How objects lie in a room: evenly spread, or crowded about one point, at 12 sizes from the room's on, each
/// half the one before.
enum class Spread { even, clustered };

/// Triangles in a room of edge 1, as large as the space that each has to itself allows.
std::vector<first_contact::Triangle> shards(std::size_t count, Spread spread, std::uint64_t seed);

/// Points in a room of edge 1, as bounds of no size.
std::vector<first_contact::Bounds> points(std::size_t count, Spread spread, std::uint64_t seed);

/// Balls that fly from anywhere to anywhere in a room; their radius is a hundredth of its longest edge.
std::vector<first_contact::Moving<first_contact::Sphere>> flights(std::size_t count,
                                                                  const first_contact::Bounds& room,
                                                                  std::uint64_t seed);

/// Balls that fly from anywhere in the room toward a corner of any triangle.
std::vector<first_contact::Moving<first_contact::Sphere>> flights_at(
    const std::vector<first_contact::Triangle>& triangles, std::size_t count,
    const first_contact::Bounds& room, std::uint64_t seed);
