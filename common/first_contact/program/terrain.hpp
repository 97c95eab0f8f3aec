#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "first_contact/geometry/mesh.hpp"

namespace first_contact::program {

/// The triangles of a grid of n n squares, two of each, over (n + 1)^2 vertices in rows.
std::vector<Mesh::Face> grid_faces(std::uint32_t n);

/// The surface z = height(x, y) over the square from (0, 0) to (side, side), in 2 n n triangles. The height
/// is asked for once at each vertex, row by row.
Mesh height_field(std::uint32_t n, double side, const std::function<double(double x, double y)>& height);

/// A bumpy terrain of 2 n n triangles over the square from (0, 0) to (64, 64): hills of three sizes, and each
/// vertex a little off. What chapters walk over, and what sweeps are measured on.
Mesh terrain(std::uint32_t n, std::uint64_t seed = 1);

}  // namespace first_contact::program
