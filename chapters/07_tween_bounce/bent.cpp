#include "bent.hpp"

#include "first_contact/geometry/products.hpp"
#include "first_contact/motion/arc_length.hpp"

using namespace first_contact;

namespace tween_bounce {

//! [bent]
Bent bent(const Bezier& curve, double part) {
  const ArcLength length(curve);
  const double even = length.parameter(part * length.total());
  return {length.total(), norm(curve.derivative().at(part)), curve.at(part), even, curve.at(even)};
}

// Each point of a level is that of the curve of the points above it alone.
std::vector<std::vector<Point>> cut_corners(const Bezier& curve, double parameter) {
  const std::vector<Point>& control = curve.control_points();
  std::vector<std::vector<Point>> levels;
  for (std::size_t count = 1; count <= control.size(); ++count) {
    std::vector<Point>& level = levels.emplace_back();
    for (std::size_t i = 0; i + count <= control.size(); ++i) {
      const auto first = control.begin() + static_cast<std::ptrdiff_t>(i);
      level.push_back(Bezier({first, first + static_cast<std::ptrdiff_t>(count)}).at(parameter));
    }
  }
  return levels;
}
//! [bent]

}  // namespace tween_bounce
