#pragma once
#include <cstdint>

#include "first_contact/program/program.hpp"
#include "stage.hpp"

/// All figures of the chapter.
void draw_partitioning_figures(const first_contact::program::Program& program, std::uint64_t seed,
                               const Stage& stage);

/// A coin in a room, and the cubes of an octree on the way to it.
void draw_octree(const first_contact::figure::Studio& studio);
/// Walls seen from above, the parts of space that a BSP tree makes of them, and the tree.
void draw_bsp(const first_contact::figure::Studio& studio);
/// A box whose sides are moved out, and the part of a path that is between all of them.
void draw_slabs(const first_contact::program::Program& program);
/// Motions before, behind and across a plane.
void draw_same_side(const first_contact::figure::Studio& studio);
/// Planes grown by r stick out at a sharp edge.
void draw_grown_planes(const first_contact::figure::Studio& studio);
/// A point against a box, a point against a shape, a box against a box.
void draw_hit_tests(const first_contact::figure::Studio& studio, const Stage& stage);
/// A plane that keeps a ball and a triangle apart, and when the ball comes to it.
void draw_support(const first_contact::figure::Studio& studio);
/// A ball sunk in a hill: over which parts of it is its centre?
void draw_cones(const first_contact::figure::Studio& studio);
/// Depth, work to build, and tests against the number of objects, as measured.
void draw_costs(const first_contact::program::Program& program, std::uint64_t seed);
