#include <array>

#include "figures.hpp"
#include "first_contact/figure/scene.hpp"
#include "first_contact/partition/octree.hpp"
#include "room.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

namespace {

const Sphere coin{{0.655, 0.155, 0.29}, 0.035};

// The coin, and other things that lie about.
std::vector<Bounds> things() {
  std::vector<Bounds> all{bounds_of(coin)};
  Random random(5);
  for (int i = 0; i < 14; ++i) {
    const Point at = Point::Constant(0.06) + 0.88 * random.vector();
    all.emplace_back(at - Vector::Constant(0.025), at + Vector::Constant(0.025));
  }
  all.emplace_back(Point(0.72, 0.30, 0.33), Point(0.77, 0.35, 0.38));
  all.emplace_back(Point(0.55, 0.08, 0.05), Point(0.60, 0.13, 0.10));
  return all;
}

Box box_of(const Bounds& bounds) {
  const Vector size = bounds.size();
  return {bounds.center(), {size.x(), 0, 0}, {0, size.y(), 0}, {0, 0, size.z()}};
}

// The twelve edges of a cube.
void add_edges(figure::Scene& scene, const Point& low, double side, const Pen& pen, int layer) {
  for (int axis = 0; axis < 3; ++axis)
    for (unsigned corner = 0; corner < 4; ++corner) {
      Point from = low;
      from[(axis + 1) % 3] += (corner & 1U) ? side : 0;
      from[(axis + 2) % 3] += (corner & 2U) ? side : 0;
      scene.line({from, from + side * Vector::Unit(axis)}, pen, layer);
    }
}

bool holds_coin(const Octree& tree, const Octree::Node& node) {
  for (std::uint32_t i = node.begin; i < node.end; ++i)
    if (tree.order()[i] == 0) return true;
  return false;
}

}  // namespace

void draw_octree(const Studio& studio) {
  const auto all = things();
  const Octree tree(all, OctreeLimits{1, 20});
  figure::Scene scene({70, 26}, 0.03);
  const std::array<Pen, 5> pens{Pen{colour::ink, 2.2}, Pen{colour::blue, 1.7}, Pen{colour::green, 1.4},
                                Pen{colour::orange, 1.2}, Pen{colour::pink, 1.2}};
  std::size_t level = 0;
  for (std::uint32_t at = 0;; ++level) {  // down to the coin's leaf, all eight children on the way
    const Octree::Node& node = tree.node(at);
    if (level == 0) add_edges(scene, node.low, node.side, pens[0], 0);
    if (node.is_leaf()) break;
    for (std::uint32_t i = 0; i < 8; ++i) {
      const Octree::Node& child = tree.node(node.first_child + i);
      add_edges(scene, child.low, child.side, pens[std::min<std::size_t>(level + 1, 4)], 0);
      if (holds_coin(tree, child)) at = node.first_child + i;
    }
  }
  for (std::size_t i = 1; i < all.size(); ++i) scene.box(box_of(all[i]), {colour::sky, 1, true}, 0);
  scene.sphere(coin, colour::amber, 1, 1);
  Figure figure(studio, "octree", scene.size());
  scene.draw(figure);
  figure.draw();
}
