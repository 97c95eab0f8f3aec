#include "bunny_mesh.hpp"

#include <cstdint>
#include <vector>

#include "page.hpp"

namespace touch {

using first_contact::Mesh, first_contact::Point;

Mesh bunny_mesh() {
  const std::vector<double> numbers = given("bunny/vertices"), corners = given("bunny/faces");
  std::vector<Point> vertices;
  for (std::size_t i = 0; i < numbers.size(); i += 3)
    vertices.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  std::vector<Mesh::Face> faces;
  for (std::size_t i = 0; i < corners.size(); i += 3)
    faces.push_back(
        {std::uint32_t(corners[i]), std::uint32_t(corners[i + 1]), std::uint32_t(corners[i + 2])});
  return {std::move(vertices), std::move(faces)};
}

}  // namespace touch
