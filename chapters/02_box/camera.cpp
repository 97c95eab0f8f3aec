#include "camera.hpp"

#include <algorithm>
#include <cmath>

#include "first_contact/geometry/frustum.hpp"

using namespace first_contact;

namespace box_chapter {

//! [camera]
Transform camera() {
  const Eigen::Matrix3d axes = (Eigen::Matrix3d() << 0, 0, -1, -1, 0, 0, 0, 1, 0).finished();  // x along -z
  const Rigid stand(Eigen::Quaterniond(axes), {0, 0, 0});
  return Transform::perspective(2 * std::atan(0.2), 2.8, 1.2, 6).after(stand.inverse().transform());
}

Seen seen(const Box& box) {
  const Frustum frustum(camera());
  Seen found{{}, {}, {}, rejected(frustum, box)};
  for (std::size_t i = 0; i < frustum.planes.size(); ++i) {
    found.distance[i] = frustum.planes[i].signed_distance(box.center);
    found.radius[i] = box.effective_radius(frustum.planes[i].normal());
    found.highest[i] = found.distance[i] + found.radius[i];
  }
  return found;
}
//! [camera]

std::size_t Seen::worst() const {
  return static_cast<std::size_t>(std::min_element(highest.begin(), highest.end()) - highest.begin());
}

}  // namespace box_chapter
