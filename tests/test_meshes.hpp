#pragma once
// Small surfaces that the tests share.
#include <cmath>
#include <cstdint>
#include <vector>

#include "first_contact/geometry/mesh.hpp"

namespace test_meshes {

using first_contact::Mesh;
using first_contact::Point;
using first_contact::Vector;

/// The cube [-1, 1]^3, its normals outward.
inline Mesh cube() {
  std::vector<Point> vertices;
  for (int i = 0; i < 8; ++i) vertices.emplace_back((i & 1) ? 1 : -1, (i & 2) ? 1 : -1, (i & 4) ? 1 : -1);
  return {vertices,
          {{0, 2, 3},
           {0, 3, 1},
           {4, 5, 7},
           {4, 7, 6},
           {0, 1, 5},
           {0, 5, 4},
           {2, 6, 7},
           {2, 7, 3},
           {0, 4, 6},
           {0, 6, 2},
           {1, 3, 7},
           {1, 7, 5}}};
}

/// A floor z = 0 of n x n unit squares, each cut in two, from the origin.
inline Mesh tiled_floor(int n) {
  std::vector<Point> vertices;
  std::vector<Mesh::Face> faces;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) vertices.emplace_back(x, y, 0);
  const auto at = [n](int x, int y) { return static_cast<std::uint32_t>(y * (n + 1) + x); };
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      faces.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      faces.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  return {vertices, faces};
}

/// A strip along y that bends at x = 0: from each side the surface rises with this slope (a valley), or falls
/// (a ridge, if negative).
inline Mesh bend(double slope) {
  return {
      {{0, 0, 0}, {0, 4, 0}, {-4, 0, 4 * slope}, {-4, 4, 4 * slope}, {4, 0, 4 * slope}, {4, 4, 4 * slope}},
      {{0, 1, 2}, {1, 3, 2}, {0, 4, 1}, {1, 4, 5}}};
}

/// A closed fan about the origin; its rim's heights say whether it is a peak, flat, or a saddle.
inline Mesh fan(const std::vector<double>& heights) {
  std::vector<Point> vertices{{0, 0, 0}};
  std::vector<Mesh::Face> faces;
  const auto n = static_cast<std::uint32_t>(heights.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * std::acos(-1.0) * i / n;
    vertices.emplace_back(std::cos(angle), std::sin(angle), heights[i]);
    faces.push_back({0, 1 + i, 1 + (i + 1) % n});
  }
  return {vertices, faces};
}

/// The same triangles, none sharing a vertex with another, as STL stores them.
inline Mesh unwelded(const Mesh& mesh) {
  std::vector<Point> vertices;
  std::vector<Mesh::Face> faces;
  for (const Mesh::Face& face : mesh.faces()) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (const std::uint32_t vertex : face) vertices.push_back(mesh.vertices()[vertex]);
    faces.push_back({first, first + 1, first + 2});
  }
  return {vertices, faces};
}

/// Each vertex p becomes map(p).
template <class Map>
Mesh mapped(const Mesh& mesh, const Map& map) {
  std::vector<Point> vertices;
  for (const Point& p : mesh.vertices()) vertices.push_back(map(p));
  return {vertices, mesh.faces()};
}

}  // namespace test_meshes
