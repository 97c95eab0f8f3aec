#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "first_contact/geometry/mesh.hpp"

namespace first_contact {

/// How many corners a face may have that is not convex: cutting such a one takes time that grows with their
/// square.
inline constexpr std::size_t most_corners = 20000;

/// The faces of a mesh file, each of three corners or more. They are cut into triangles when all vertices are
/// known.
class Polygons {
 public:
  /// \param place  where the file has it: a line, or a byte
  void add(std::span<const std::uint32_t> corners, std::size_t place);

  /// How many there are.
  std::size_t size() const { return ends_.size(); }
  /// The numbers of a face's vertices.
  std::span<const std::uint32_t> operator[](std::size_t i) const;
  /// Where the file has it.
  std::size_t place(std::size_t i) const { return places_[i]; }

 private:
  std::vector<std::uint32_t> corners_;
  std::vector<std::size_t> ends_, places_;
};

/// How a face was cut into triangles.
enum class Cut {
  whole,     ///< the triangles fill the face and nothing else
  crossing,  ///< it crosses itself, so that nobody can tell what it fills: a fan from its first corner
  too_long   ///< not at all: it is not convex and has more than `most_corners` corners
};

/// Adds a face's triangles: a fan from the first corner if it is convex, else ears; n - 2 in any case, in the
/// order of the corners. The face is seen along the coordinate axis to which its plane is most nearly
/// perpendicular; so it need not be quite flat.
Cut add_triangles(std::vector<Mesh::Face>& faces, const std::vector<Point>& vertices,
                  std::span<const std::uint32_t> polygon);

}  // namespace first_contact
