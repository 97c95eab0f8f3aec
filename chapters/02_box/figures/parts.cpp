#include "parts.hpp"

#include <cmath>

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

Point on(const Plane& plane, const Point& p) { return p - plane.signed_distance(p) * plane.normal(); }

std::vector<Point> shadow(const Box& box, const Plane& plane) {
  const Vector u = plane.normal().unitOrthogonal(), v = plane.normal().cross(u);
  std::vector<Point> outline;
  for (int i = 0; i < 360; ++i) {
    const Vector along = std::cos(degree * i) * u + std::sin(degree * i) * v;
    Point farthest = box.center;
    for (const Vector& axis : {box.r, box.s, box.t}) farthest += std::copysign(0.5, axis.dot(along)) * axis;
    const Point corner = on(plane, farthest);
    if (outline.empty() || (corner - outline.back()).norm() > 1e-9) outline.push_back(corner);
  }
  return outline;
}

std::string name_of(const ContactPoints& points, Eigen::Index i) {
  return "{/:Italic C}" + (points.cols() > 1 ? "_" + std::to_string(i + 1) : std::string());
}

void mark_contact(figure::Scene& scene, const ContactPoints& points) {
  std::vector<Point> corners;
  for (const auto& p : points.colwise()) corners.emplace_back(p);
  if (corners.size() == 4) scene.polygon(corners, {colour::red, 0.25}, 3);
  if (corners.size() > 2) corners.push_back(corners.front());
  if (corners.size() > 1) scene.line(corners, {colour::red, 2.4}, 4);
  for (const Point& p : corners) scene.dot(p, colour::red);
}
