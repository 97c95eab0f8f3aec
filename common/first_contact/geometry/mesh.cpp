#include "first_contact/geometry/mesh.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "first_contact/geometry/refuse.hpp"
#include "first_contact/geometry/unit_scale.hpp"

namespace first_contact {

Mesh::Mesh(std::vector<Point> vertices, std::vector<Face> faces)
    : vertices_(std::move(vertices)), faces_(std::move(faces)) {
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    if (!in_range(vertices_[i])) require_finite(vertices_[i], "mesh's vertex " + std::to_string(i));
    largest_coordinate_ = std::max(largest_coordinate_, largest(vertices_[i]));
  }
  for (std::size_t i = 0; i < faces_.size(); ++i)
    for (const std::uint32_t vertex : faces_[i])
      if (vertex >= vertices_.size())
        refuse("mesh's face " + std::to_string(i) + " names vertex " + std::to_string(vertex),
               "must be below " + std::to_string(vertices_.size()));
}

Triangle Mesh::triangle(std::size_t i) const {
  const Face& face = faces_[i];
  return {vertices_[face[0]], vertices_[face[1]], vertices_[face[2]]};
}

std::vector<Triangle> Mesh::triangles() const {
  std::vector<Triangle> all;
  all.reserve(size());
  for (std::size_t i = 0; i < size(); ++i) all.push_back(triangle(i));
  return all;
}

}  // namespace first_contact
