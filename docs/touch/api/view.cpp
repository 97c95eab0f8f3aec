#include "view.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "page.hpp"

namespace touch {

View::View(double turn, double tilt, const Point& middle) : middle(middle) {
  constexpr double degree = std::numbers::pi / 180;
  const double a = turn * degree, b = tilt * degree;
  eye = {std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b)};
  right = {-std::sin(a), std::cos(a), 0};
  up = eye.cross(right);
}

void View::tell() const {
  touch::tell("drawn/view/middle", middle);
  touch::tell("drawn/view/eye", eye);
  touch::tell("drawn/view/right", right);
  touch::tell("drawn/view/up", up);
}

Point middle_of(const Mesh& mesh) {
  Eigen::AlignedBox3d bounds;
  for (const Point& vertex : mesh.vertices()) bounds.extend(vertex);
  return bounds.center();
}

Point in_thousandths(const Point& point) {
  return point.unaryExpr([](double each) { return std::round(1000 * each) / 1000 + 0.0; });  // and no -0
}

void tell_mesh(const Mesh& mesh) {
  std::vector<double> vertices, faces;
  for (const Point& vertex : mesh.vertices()) vertices.insert(vertices.end(), vertex.begin(), vertex.end());
  for (const Mesh::Face& face : mesh.faces()) faces.insert(faces.end(), face.begin(), face.end());
  touch::tell("vertices", vertices);
  touch::tell("faces", faces);
}

}  // namespace touch
