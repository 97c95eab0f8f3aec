#include "first_contact/trees/octree.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "figures.hpp"
#include "first_contact/figure/scene.hpp"

using namespace first_contact;
using namespace first_contact::figure;
namespace colour = first_contact::figure::colour;

namespace {

const Sphere coin{{0.655, 0.205, 0.315}, 0.035};

const View view{70, 26};

// The coin, and other things that lie about; two of them near it, so that the room is divided again and again
// there.
std::vector<Bounds> things() {
  std::vector<Bounds> all{bounds_of(coin)};
  for (const Point& at :
       {Point(0.735, 0.195, 0.285), Point(0.63, 0.08, 0.44), Point(0.03, 0.70, 0.03), Point(0.30, 0.35, 0.97),
        Point(0.88, 0.93, 0.66), Point(0.20, 0.15, 0.30), Point(0.90, 0.30, 0.80), Point(0.45, 0.80, 0.60),
        Point(0.80, 0.70, 0.12), Point(0.90, 0.03, 0.10), Point(0.12, 0.55, 0.75)}) {
    const Vector half = Vector::Constant(0.025);
    all.emplace_back(at - half, at + half);
  }
  return all;
}

// The sides of an upright box that the eye sees.
void add_sides(figure::Scene& scene, const Bounds& box, const Fill& fill, int layer) {
  const Vector half = 0.5 * box.sizes(), eye = view.eye();
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const Vector out = std::copysign(half[axis], eye[axis]) * Vector::Unit(axis);
    scene.patch(middle_of(box) + out, half[u] * Vector::Unit(u), half[v] * Vector::Unit(v), fill, layer);
  }
}

Bounds cube_of(const Octree::Node& node) { return {node.low, node.low + Vector::Constant(node.side)}; }

// The room: its edges before everything in it, and those that are hidden behind it.
void add_room(figure::Scene& scene, const Bounds& room) {
  const Vector eye = view.eye();
  for (int axis = 0; axis < 3; ++axis)
    for (unsigned corner = 0; corner < 4; ++corner) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      const bool high_u = corner & 1U, high_v = corner & 2U;
      Point from = room.min();
      if (high_u) from[u] = room.max()[u];
      if (high_v) from[v] = room.max()[v];
      const bool hidden = high_u != (eye[u] > 0) && high_v != (eye[v] > 0);
      const Point to = from + room.sizes()[axis] * Vector::Unit(axis);
      scene.line({from, to}, hidden ? Pen{colour::grey, 1.2} : Pen{colour::ink, 2.0}, hidden ? -1 : 1);
    }
}

// The three planes that part a cube into eight, as crosses of lines on its sides and through its middle.
void add_division(figure::Scene& scene, const Octree::Node& cube, const Pen& pen) {
  constexpr int pieces = 4;
  const Point middle = cube.low + Vector::Constant(cube.side / 2);
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        if (i != 1 && j != 1) continue;  // that is an edge of the cube itself
        Point from = middle - cube.side / 2 * Vector::Unit(axis);
        from[(axis + 1) % 3] += (i - 1) * cube.side / 2;
        from[(axis + 2) % 3] += (j - 1) * cube.side / 2;
        const Vector step = cube.side / pieces * Vector::Unit(axis);
        for (int k = 0; k < pieces; ++k) scene.line({from + k * step, from + (k + 1) * step}, pen, 0);
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
  figure::Scene scene(view, 0.03);
  const std::array<Pen, 4> pens{Pen{colour::blue, 1.6}, Pen{colour::green, 1.4}, Pen{colour::red, 1.2},
                                Pen{colour::pink, 1.2}};
  add_room(scene, cube_of(tree.node(0)));
  std::uint32_t at = 0;
  for (std::size_t level = 0; !tree.node(at).is_leaf(); ++level) {  // down to the leaf that holds the coin
    const Pen& pen = pens[std::min<std::size_t>(level, 3)];
    add_division(scene, tree.node(at), pen);
    at = tree.node(at).first_child;
    while (!holds_coin(tree, tree.node(at))) ++at;
    add_sides(scene, cube_of(tree.node(at)), {pen.colour, 0.10}, -1);
  }
  for (std::size_t i = 1; i < all.size(); ++i) add_sides(scene, all[i], {colour::pale, 1, true}, 0);
  scene.sphere(coin, colour::amber, 1, 2);
  Figure figure(studio, "octree", scene.size());
  scene.draw(figure);
  figure.draw();
}
