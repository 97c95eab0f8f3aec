#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "first_contact/geometry/triangle.hpp"

namespace first_contact {

/// Triangles that share vertices: a surface, open or closed, or any soup of triangles.
class Mesh {
 public:
  /// The numbers of a face's three vertices.
  using Face = std::array<std::uint32_t, 3>;

  /// \throws std::invalid_argument if a vertex is not finite, or a face names a vertex that does not exist.
  Mesh(std::vector<Point> vertices, std::vector<Face> faces);

  /// All vertices.
  const std::vector<Point>& vertices() const { return vertices_; }
  /// All faces.
  const std::vector<Face>& faces() const { return faces_; }
  /// The largest coordinate of a vertex, without its sign; 0 if there is none.
  double largest_coordinate() const { return largest_coordinate_; }
  /// The number of triangles.
  std::size_t size() const { return faces_.size(); }
  /// The triangle with number i < size().
  Triangle triangle(std::size_t i) const;
  /// All triangles.
  std::vector<Triangle> triangles() const;

 private:
  std::vector<Point> vertices_;
  std::vector<Face> faces_;
  double largest_coordinate_ = 0;
};

}  // namespace first_contact
