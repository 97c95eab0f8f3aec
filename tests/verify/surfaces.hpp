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

/// Bumpy and flat grids, loose triangles, slivers, duplicates, T-junctions, degenerate triangles, fans,
/// closed bodies, and books of several pages at one edge.
inline constexpr int kinds = 10;
const char* name(int kind);
Mesh surface(int kind, Random& random);

/// One triangle, of any thinness.
Mesh sliver(Random& random);

/// The mesh at any scale from 1e-6 to 1e6, turned, and moved away from the origin by up to a thousand times
/// its size.
Mesh placed(const Mesh& mesh, Random& random);

/// A sphere on its way to a vertex, an edge, a seam or a face, squarely or so that it hardly touches, or in
/// its midst; a sphere of radius 0, a ray, to any of them; or a ray or a sphere of any size, however small,
/// at an angle to a face that is as flat as may be.
inline constexpr int aims = 8, flat = 7;
const char* aim_name(int aim);
Moving<Sphere> cast(const Mesh& mesh, int aim, Random& random);

}  // namespace surfaces
