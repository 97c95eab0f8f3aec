#pragma once
#include <random>
#include <vector>

#include "first_contact/geometry/mesh.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/program/terrain.hpp"
#include "first_contact/sweep/contact.hpp"

/// \file
/// The scenes in which sweeps are measured and verified: surfaces of any size, and casts of four kinds.

namespace scenes {

using namespace first_contact;

using program::terrain;

/// How far casts go: a micro cast less than it is wide; a hop .05 to .5; a long one 5 to 60; an aimed one 1
/// to 8, straight at a vertex, at a point of an edge, or so that it grazes one.
enum class Kind { micro, hop, length, aimed };
inline constexpr Kind kinds[] = {Kind::micro, Kind::hop, Kind::length, Kind::aimed};
const char* to_string(Kind kind);

/// Casts near the surface; radii log-uniform between .01 and .5 of `unit`, as are the distances.
std::vector<Moving<Sphere>> casts(const Mesh& mesh, Kind kind, std::size_t count, std::uint64_t seed,
                                  double unit);

}  // namespace scenes
