// Chapter 3: a leaf, a hook and a pointer on a stage, and the hit tests of each with each.
#include <algorithm>
#include <string>

#include "03_partitioning/stage.hpp"
#include "page.hpp"

using namespace first_contact;
using touch::tell;
using touch::tell_whether;

namespace {

void tell_outline(const std::string& name, const StageObject& object) {
  const auto& [low, high] = object.bounding_box();
  tell(name + "/box", std::vector{low.x(), low.y(), high.x(), high.y()});
  std::vector<double> corners;
  for (const Point2& p : object.outline()) corners.insert(corners.end(), {p.x(), p.y()});
  tell(name + "/corners", corners);
}

// Where the ray from the pointer to the right leaves or enters the shape. Of each side the upper end does not belong to it.
std::vector<double> crossings(const StageObject& object, const Point2& p) {
  std::vector<double> all;
  const auto& outline = object.outline();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    if ((a.y() <= p.y()) == (b.y() <= p.y())) continue;
    const double x = a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    if (x > p.x()) all.insert(std::upper_bound(all.begin(), all.end(), x), x);
  }
  return all;
}

}  // namespace

FOR_THE_PAGE(hit_test)
(double leaf_x, double leaf_y, double hook_x, double hook_y, double x, double y) {
  const Stage stage({{leaf_x, leaf_y}, {hook_x, hook_y}, {x, y}});
  tell_whether("hit_tests/boxes", hit_test_object(stage.leaf, stage.hook));
  tell_whether("hit_tests/shapes", overlap(stage.leaf, stage.hook));
  tell_whether("hit_tests/point_in_box", hit_test_point(stage.leaf, stage.pointer));
  tell_whether("hit_tests/point_in_shape", hit_test_point(stage.leaf, stage.pointer, true));
  tell_outline("drawn/leaf", stage.leaf);
  tell_outline("drawn/hook", stage.hook);
  tell("drawn/crossings", crossings(stage.leaf, stage.pointer));
}
