#pragma once
#include <random>
#include <string>
#include <vector>

#include "first_contact/geometry/mesh.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/sweep/contact.hpp"

/// \file
/// Surfaces that trouble a sweep, and casts aimed at where they do.

namespace surfaces {

using namespace first_contact;
using Random = std::mt19937_64;

/// Bumpy and flat grids, loose triangles, slivers, duplicates, T-junctions, degenerate triangles, fans.
inline constexpr int kinds = 8;
const char* name(int kind);
Mesh surface(int kind, Random& random);

/// A mesh in another place and size.
Mesh moved(const Mesh& mesh, double size, const Vector& offset);

/// A sphere on its way to a vertex, an edge, a seam or a face, squarely or so that it hardly touches.
inline constexpr int aims = 5;
const char* aim_name(int aim);
Moving<Sphere> cast(const Mesh& mesh, int aim, Random& random);

}  // namespace surfaces
