#pragma once
#include <filesystem>

#include "first_contact/geometry/mesh.hpp"

namespace first_contact::program {

/// Reads a mesh as `read_mesh` does. While a large file is read, and standard error is a terminal, a line
/// there tells how far it is; it is gone when the reading ends, well or not.
/// What had to be decided, as the file does not, is told there in a line that stays.
/// \throws MeshFileError as `read_mesh`
Mesh load_mesh(const std::filesystem::path& file);

}  // namespace first_contact::program
