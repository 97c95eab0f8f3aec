#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <stdexcept>

#include "first_contact/files/file_error.hpp"
#include "first_contact/geometry/mesh.hpp"

namespace first_contact {

/// A mesh file that cannot be read. The message names the file, the line (of a binary file the byte) and the
/// rule that is broken.
class MeshFileError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Is told, about a hundred times, what part of a file's bytes has been read: ever more, and in the end 1.
using ReadingProgress = std::function<void(double part)>;

/// What a reader had to decide, as the file does not.
struct ReadingNotes {
  std::size_t crossing = 0;  ///< faces that cross themselves, each cut into a fan of triangles all the same
};

/// Reads a mesh. The ending of the name, in capitals or not, tells the format:
/// - `.obj` (Wavefront): `v` and `f`, with `a/b/c` and negative numbers; all else is passed over;
/// - `.off`: with or without colours, normals and texture coordinates, which are passed over;
/// - `.ply`: ASCII, little-endian and big-endian; all but the vertices' x, y, z and the faces' lists is
///   passed over, and each strip of a list tristrips is read as faces too;
/// - `.stl`: ASCII and binary; corners at equal positions become one vertex.
///
/// Coordinates are the doubles nearest to the digits in the file. A polygon that is convex is cut into a fan
/// of triangles from its first corner, any other into ears, so that the triangles fill just the polygon.
/// Memory grows with the file's bytes, never with the counts that it promises. A byte order mark is read
/// past.
/// \param progress  if given, it is told how far the reading is
/// \param notes  if given, it is told what had to be decided
/// \throws MeshFileError if the file is missing, empty, of another format, cut short, longer than its own
///     counts say, or without a face; if a coordinate is malformed, infinite or not a number; if a face names
///     a vertex that does not exist; if there is not enough memory for it.
Mesh read_mesh(const std::filesystem::path& file, const ReadingProgress& progress = {},
               ReadingNotes* notes = nullptr);

/// Writes a mesh in the format OFF, with the fewest digits that give the same doubles again. The file appears
/// whole or not at all.
/// \throws FileError that names the file if it cannot be written.
void write_off(const std::filesystem::path& file, const Mesh& mesh);

}  // namespace first_contact
