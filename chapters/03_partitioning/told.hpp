#pragma once
#include <string>

#include "first_contact/geometry/sphere.hpp"
#include "first_contact/program/program.hpp"
#include "first_contact/sweep/moving.hpp"
#include "stage.hpp"

/// What the program tells of the flat scenes.

namespace partitioning_chapter {

/// A number with so many digits after the point.
std::string fixed(double value, int digits);
/// "true" or "false"
std::string truth(bool value);

/// hitTestPoint and hitTestObject (paper, 2.4.1).
void tell_hit_tests(first_contact::program::Program& program, const Stage& stage);

/// A ball that rolls among walls, seen from above: the figure to touch.
void tell_walls(first_contact::program::Program& program,
                const first_contact::Moving<first_contact::Sphere>& ball);

}  // namespace partitioning_chapter
