// Chapter 2: a plank before a camera, as seen from above: which planes of the frustum is it behind?
#include "first_contact/geometry/frustum.hpp"

#include "02_box/camera.hpp"
#include "page.hpp"

using namespace first_contact;
using touch::tell;

namespace {

void tell_drawing(const Box& box) {
  const Transform camera = box_chapter::camera(), back = camera.inverse();
  std::vector<double> corners, vertices, planes;
  for (const auto& [across, depth] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
    const Point corner = back.point({double(across), 0, double(depth)});
    corners.insert(corners.end(), {corner.x(), corner.y()});
  }
  for (const Point& vertex : box.vertices())
    vertices.insert(vertices.end(), {vertex.x(), vertex.y(), vertex.z()});
  for (const Plane& plane : Frustum(camera).planes)
    planes.insert(planes.end(), {plane.normal().x(), plane.normal().y(), plane.offset()});
  tell("drawn/frustum", corners);
  tell("drawn/box", vertices);
  tell("drawn/planes", planes);
}

}  // namespace

FOR_THE_PAGE(frustum)
(double x, double y, double rx, double ry, double sx, double sy) {
  const Box box{{x, y, 0}, {rx, ry, 0}, {sx, sy, 0}, {0, 0, 0.8}};
  const box_chapter::Seen seen = box_chapter::seen(box);
  for (std::size_t i = 0; i < seen.highest.size(); ++i)
    tell(std::string("camera/highest/") + box_chapter::plane_names[i], seen.highest[i]);
  touch::tell_whether("camera/rejected", seen.rejected);
  tell("drawn/worst", static_cast<double>(seen.worst()));
  tell_drawing(box);
}
