#pragma once
#include "first_contact/geometry/mesh.hpp"

namespace touch {

/// chapters/meshes/bunny.off, as it is read by a program.
first_contact::Mesh bunny_mesh();

}  // namespace touch
