#include "stage.hpp"

#include <array>

using namespace first_contact;

namespace {

constexpr std::array<std::array<double, 2>, 3> sail{{{0, 0}, {3.4, 0}, {0, 3.4}}};
constexpr std::array<std::array<double, 2>, 6> angle{
    {{0, 0}, {0.7, 0}, {0.7, 2.3}, {-1.9, 2.3}, {-1.9, 1.6}, {0, 1.6}}};

template <std::size_t n>
StageObject placed(const std::array<std::array<double, 2>, n>& corners, const Point2& at) {
  std::vector<Point2> outline;
  for (const auto& [u, v] : corners) outline.emplace_back(u, v);
  return StageObject(outline, Eigen::Affine2d(Eigen::Translation2d(at)));
}

}  // namespace

Stage::Stage(const Places& places)
    : leaf(placed(sail, places.leaf)), hook(placed(angle, places.hook)), pointer(places.pointer) {}
