#include "first_contact/bvh/build/surface.hpp"

#include <limits>

namespace first_contact::bvh {

namespace {

/// Calls visit for each vertex of a triangle, once.
template <class Visit>
void each_vertex(const Place& place, const Visit& visit) {
  const auto& [a, b, c] = place.corner;
  visit(a);
  if (b != a) visit(b);
  if (c != a && c != b) visit(c);
}

}  // namespace

Surface::Surface(const Mesh& mesh, const Merged& merged, const std::vector<std::uint32_t>& order) {
  number_vertices(mesh, merged, order);
  gather_triangles();
}

/// In the order in which the triangles use them.
void Surface::number_vertices(const Mesh& mesh, const Merged& merged,
                              const std::vector<std::uint32_t>& order) {
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> here(mesh.vertices().size(), none);
  places_.reserve(order.size());
  vertices_.reserve(mesh.vertices().size() + 1);
  for (const std::uint32_t number : order) {
    Place& place = places_.emplace_back(Place{number, {}});
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t vertex = merged.representative(mesh.faces()[number][i]);
      if (here[vertex] == none) {
        here[vertex] = static_cast<std::uint32_t>(vertices_.size());
        vertices_.push_back({mesh.vertices()[vertex], vertex, 0});
      }
      place.corner[i] = here[vertex];
    }
  }
  vertices_.push_back({Point::Zero(), none, 0});
}

void Surface::gather_triangles() {
  std::vector<std::uint32_t> place_of(places_.size());
  for (std::uint32_t i = 0; i < places_.size(); ++i) place_of[places_[i].number] = i;
  for (const Place& place : places_)
    each_vertex(place, [&](std::uint32_t vertex) { ++vertices_[vertex].around; });
  std::uint32_t sum = 0;
  for (Vertex& vertex : vertices_) vertex.around = sum += vertex.around;  // each list's end ...
  around_.resize(sum);
  for (std::size_t number = place_of.size();
       number-- > 0;) {  // ... becomes its beginning, filled from behind
    const std::uint32_t place = place_of[number];
    each_vertex(places_[place], [&](std::uint32_t vertex) { around_[--vertices_[vertex].around] = place; });
  }
}

}  // namespace first_contact::bvh
