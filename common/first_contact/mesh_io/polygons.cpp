#include "first_contact/mesh_io/polygons.hpp"

#include <algorithm>
#include <cmath>

#include "first_contact/geometry/products.hpp"
#include "first_contact/mesh_io/flat_polygon.hpp"

namespace first_contact {
namespace {

// The corners with coordinates of at most 1: shorter by a power of two, which rounds nothing.
std::vector<Point> shrunk(const std::vector<Point>& vertices, std::span<const std::uint32_t> polygon) {
  double largest = 0;
  for (const std::uint32_t corner : polygon)
    largest = std::max(largest, vertices[corner].lpNorm<Eigen::Infinity>());
  const int exponent = largest > 0 ? std::ilogb(largest) + 1 : 0;
  std::vector<Point> corners;
  for (const std::uint32_t corner : polygon)
    corners.push_back(vertices[corner].unaryExpr([&](double x) { return std::scalbn(x, -exponent); }));
  return corners;
}

// Along the normal, as long as twice the area (M. E. Newell's way: also right for a face that is not quite
// flat). Where all parts of the area cancel, the normal of the largest part.
Vector newell_normal(const std::vector<Point>& corners) {
  Vector normal = Vector::Zero(), largest = Vector::Zero();
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const Vector part = (corners[i - 1] - corners[0]).cross(corners[i] - corners[0]);
    if (squared_norm(part) > squared_norm(largest)) largest = part;
    normal += part;
  }
  return normal.isZero(0) ? largest : normal;
}

// Seen from the front along the axis that is nearest to the normal.
FlatPolygon flattened(const std::vector<Point>& corners) {
  const Vector normal = newell_normal(corners);
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  Eigen::Index x = (axis + 1) % 3, y = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(x, y);
  FlatPolygon flat;
  for (const Point& corner : corners) flat.emplace_back(corner[x], corner[y]);
  return flat;
}

void add_fan(std::vector<Mesh::Face>& faces, std::span<const std::uint32_t> polygon) {
  for (std::size_t i = 2; i < polygon.size(); ++i) faces.push_back({polygon[0], polygon[i - 1], polygon[i]});
}

}  // namespace

void Polygons::add(std::span<const std::uint32_t> corners, std::size_t place) {
  corners_.insert(corners_.end(), corners.begin(), corners.end());
  ends_.push_back(corners_.size());
  places_.push_back(place);
}

std::span<const std::uint32_t> Polygons::operator[](std::size_t i) const {
  const std::size_t begin = i == 0 ? 0 : ends_[i - 1];
  return std::span(corners_).subspan(begin, ends_[i] - begin);
}

Cut add_triangles(std::vector<Mesh::Face>& faces, const std::vector<Point>& vertices,
                  std::span<const std::uint32_t> polygon) {
  if (polygon.size() == 3) return add_fan(faces, polygon), Cut::whole;
  const FlatPolygon flat = flattened(shrunk(vertices, polygon));
  if (is_strictly_convex(flat)) return add_fan(faces, polygon), Cut::whole;
  if (polygon.size() > most_corners) return Cut::too_long;
  const bool crossing = crosses_itself(flat);
  const auto ears = crossing ? std::vector<std::array<std::size_t, 3>>() : clip_ears(flat);
  if (ears.size() + 2 < polygon.size()) return add_fan(faces, polygon), Cut::crossing;
  for (const auto& [a, b, c] : ears) faces.push_back({polygon[a], polygon[b], polygon[c]});
  return Cut::whole;
}

}  // namespace first_contact
