#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "first_contact/bvh/build/layout.hpp"
#include "first_contact/bvh/build/merged.hpp"
#include "first_contact/geometry/mesh.hpp"

namespace first_contact::bvh {

/// The mesh once more, in the order of a tree, and which triangles meet at a vertex.
///
/// The idea: a cast decides about triangles of one or two leaves and asks what lies around a vertex of
/// theirs. With triangles in the order of the leaves, and vertices in the order in which those use them, all
/// of this is in a few lines of memory next to each other, however a file has it. It equals
/// MeshEdges::faces_at, from which the edges at a vertex can be had in no time: what an Environment works out
/// beforehand for each edge and vertex, a cast needs only for the one that it touches.
///
/// It takes 44 of the 70 bytes of a triangle: 16 its place, 16 its share of the vertices, 12 what lies around
/// them.
class Surface {
 public:
  /// \param order  the numbers of the triangles, in the order of the tree
  Surface(const Mesh& mesh, const Merged& merged, const std::vector<std::uint32_t>& order);

  /// The triangles, with their corners by their numbers here, each vertex once.
  std::span<const Place> places() const { return places_; }
  std::size_t vertices() const { return vertices_.size() - 1; }
  const Point& position(std::uint32_t vertex) const { return vertices_[vertex].position; }
  Triangle triangle(const Place& p) const {
    return {position(p.corner[0]), position(p.corner[1]), position(p.corner[2])};
  }
  /// The lowest number that the mesh has for a vertex.
  std::uint32_t number(std::uint32_t vertex) const { return vertices_[vertex].number; }
  /// Where the triangles at a vertex are among the places; in the order of their numbers in the mesh.
  std::span<const std::uint32_t> around(std::uint32_t vertex) const {
    return {around_.data() + vertices_[vertex].around, around_.data() + vertices_[vertex + 1].around};
  }
  std::size_t bytes() const {
    return sizeof(Place) * places_.size() + sizeof(Vertex) * vertices_.size() +
           sizeof(std::uint32_t) * around_.size();
  }

 private:
  /// All that is asked of a vertex, in half a cache line.
  struct alignas(32) Vertex {
    Point position;
    std::uint32_t number, around;  // the first of the triangles around it
  };

  void number_vertices(const Mesh& mesh, const Merged& merged, const std::vector<std::uint32_t>& order);
  void gather_triangles();

  std::vector<Place> places_;
  std::vector<Vertex> vertices_;  // and one more, to end the last one's triangles
  std::vector<std::uint32_t> around_;
};

}  // namespace first_contact::bvh
