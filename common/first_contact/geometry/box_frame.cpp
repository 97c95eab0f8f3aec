#include "first_contact/geometry/box_frame.hpp"

#include <cmath>

#include "first_contact/geometry/products.hpp"

namespace first_contact {

namespace {

/// A direction for an axis of no length: at right angles to the others.
Vector across(const Vector& a, const Vector& b) {
  if (!a.isZero(0) && !b.isZero(0)) return normalized(a.cross(b));
  const Vector& only = a.isZero(0) ? b : a;
  return only.isZero(0) ? Vector(Vector::UnitX()) : only.unitOrthogonal();
}

}  // namespace

BoxFrame::BoxFrame(const Box& box) {
  const std::array<Vector, 3> axes{box.r, box.s, box.t};
  std::array<Vector, 3> along{normalized(box.r), normalized(box.s), normalized(box.t)};
  for (std::size_t i = 0; i < 3; ++i)
    if (axes[i].isZero(0)) along[i] = across(along[(i + 1) % 3], along[(i + 2) % 3]);
  for (std::size_t i = 0; i < 3; ++i) {
    normals[i] = normalized(along[(i + 1) % 3].cross(along[(i + 2) % 3]));
    half[static_cast<Eigen::Index>(i)] = 0.5 * std::abs(dot(axes[i], normals[i]));
  }
}

Vector BoxFrame::heights(const Point& point) const {
  return {dot(normals[0], point), dot(normals[1], point), dot(normals[2], point)};
}

bool BoxFrame::holds(const Point& point) const {
  return (heights(point).array().abs() <= half.array()).all();
}

}  // namespace first_contact
