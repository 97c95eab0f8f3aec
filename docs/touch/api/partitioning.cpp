// Chapter 3: a ball that rolls among walls, and the parts of a tree that the search for the first one enters.
#include <algorithm>
#include <string>
#include <utility>

#include "03_partitioning/walls.hpp"
#include "page.hpp"

using namespace first_contact;
using namespace partitioning_chapter;
using touch::tell;

namespace {

using Region = std::vector<Point>;

// A search that notes which boxes and sides it goes into: a tree shows those of its own nodes.
class NotedCast : public Cast {
 public:
  using Cast::Cast;

  bool reaches(const Bounds& box) const override {
    const bool goes_in = Cast::reaches(box);
    if (goes_in) boxes_.push_back(&box);
    return goes_in;
  }
  Sides sides(const Plane& plane, const Passage& part) const override {
    planes_.emplace_back(&plane, Cast::sides(plane, part));
    return planes_.back().second;
  }

  bool went_into(const Bounds& box) const {
    return std::find(boxes_.begin(), boxes_.end(), &box) != boxes_.end();
  }
  // Nothing of a plane that it was never shown.
  Sides went_beside(const Plane& plane) const {
    for (const auto& [shown, sides] : planes_)
      if (shown == &plane) return sides;
    return {{1, 0}, {1, 0}};
  }

 private:
  mutable std::vector<const Bounds*> boxes_;
  mutable std::vector<std::pair<const Plane*, Sides>> planes_;
};

// Of each part of the plane: how many corners, whether the search went in, whether it is a leaf, the corners.
class Parts {
 public:
  void add(const Region& region, bool went_in, bool is_leaf) {
    numbers_.insert(numbers_.end(), {double(region.size()), double(went_in), double(is_leaf)});
    for (const Point& corner : region) numbers_.insert(numbers_.end(), {corner.x(), corner.y()});
  }
  void tell() const { touch::tell("drawn/parts", numbers_); }

 private:
  std::vector<double> numbers_;
};

Region rectangle(const Point& low, const Point& high) {
  return {low, {high.x(), low.y(), 0}, high, {low.x(), high.y(), 0}};
}

// What is upwards of the walls, and empty, is not drawn.
void add_parts(Parts& parts, const Octree& tree, const NotedCast& cast) {
  for (std::size_t i = 0; i < tree.nodes(); ++i) {
    const Octree::Node& node = tree.node(i);
    if (node.low.z() > tree.node(0).low.z()) continue;
    const Point high = node.low + Vector(node.side, node.side, 0);
    parts.add(rectangle(node.low, high), cast.went_into(node.bounds), node.is_leaf());
  }
}

void add_parts(Parts& parts, const BoxTree& tree, const NotedCast& cast) {
  for (std::size_t i = 0; i < tree.nodes(); ++i) {
    const Bounds& box = tree.node(i).bounds;
    parts.add(rectangle(box.min(), box.max()), cast.went_into(box), tree.node(i).is_leaf());
  }
}

void add_below(Parts& parts, const BspTree& tree, const NotedCast& cast, std::size_t number,
               const Region& region, bool went_in) {
  const BspTree::Node& node = tree.node(number);
  parts.add(region, went_in, node.is_leaf());
  if (node.is_leaf()) return;
  const Plane& plane = *node.plane;
  const Sides sides = cast.went_beside(plane);
  add_below(parts, tree, cast, node.front, part_of(region, plane, 1), !sides.front.empty());
  add_below(parts, tree, cast, node.back, part_of(region, plane, -1), !sides.back.empty());
}

void add_parts(Parts& parts, const BspTree& tree, const NotedCast& cast) {
  add_below(parts, tree, cast, 0, rectangle({-0.3, -0.3, 0}, {6.7, 6.2, 0}), true);
}

template <class Tree>
Found tell_tree(const std::string& name, const Tree& tree, const Yard& yard, const Moving<Sphere>& ball,
                bool is_drawn) {
  NotedCast cast(ball, yard.walls, yard.bounds());
  const Found found = found_in(tree, cast);
  tell("walls/" + name + "/tests", static_cast<double>(found.counted.tests));
  tell("walls/" + name + "/nodes", static_cast<double>(found.counted.nodes));
  if (!is_drawn) return found;
  Parts parts;
  add_parts(parts, tree, cast);
  parts.tell();
  return found;
}

void tell_walls(const Yard& yard) {
  std::vector<double> ends;
  for (const Triangle& wall : yard.walls)
    ends.insert(ends.end(), {wall.a.x(), wall.a.y(), wall.b.x(), wall.b.y()});
  tell("drawn/walls", ends);
}

}  // namespace

FOR_THE_PAGE(partitioning)
(double x0, double y0, double x1, double y1, double radius, double drawn) {
  const Yard yard;
  const Moving<Sphere> ball = Roll{{x0, y0}, {x1, y1}, radius}.ball();
  tell_tree("octree", yard.octree, yard, ball, drawn == 0);
  tell_tree("bsp", yard.bsp, yard, ball, drawn == 1);
  const auto contact = tell_tree("bvh", yard.bvh, yard, ball, drawn == 2).contact;
  tell_walls(yard);
  if (!contact) return;
  tell("walls/contact/time", contact->time);
  tell("walls/contact/wall", static_cast<double>(contact->triangle));
  tell("walls/contact/normal", contact->normal);
}
