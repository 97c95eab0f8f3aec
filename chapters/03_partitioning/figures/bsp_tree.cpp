#include "first_contact/trees/bsp_tree.hpp"

#include <array>
#include <cmath>

#include "figures.hpp"
#include "first_contact/figure/scene.hpp"
#include "first_contact/trees/collection.hpp"
#include "walls.hpp"

using namespace first_contact;
using namespace first_contact::figure;
using partitioning_chapter::part_of;
namespace colour = first_contact::figure::colour;

namespace {

struct Wall {
  Point from, to;
};

const std::array<Wall, 5> walls{{{{1.1, 2.5, 0}, {2.6, 3.8, 0}},
                                 {{3.2, 0.6, 0}, {3.7, 4.2, 0}},
                                 {{0.7, 1.0, 0}, {2.5, 1.2, 0}},
                                 {{4.6, 2.9, 0}, {6.2, 3.3, 0}},
                                 {{4.5, 1.6, 0}, {5.9, 0.7, 0}}}};

// A wall is seen from above: a triangle that stands upright on it.
std::vector<Triangle> polygons() {
  std::vector<Triangle> all;
  for (const Wall& wall : walls) all.emplace_back(wall.from, wall.to, wall.from + Vector(0, 0, 1));
  return all;
}

// A node of the tree with its place in both pictures.
struct Place {
  std::uint32_t node;
  std::vector<Point> region;
  Point in_tree;
};

// Where a plane crosses a region.
std::vector<Point> cut_through(const std::vector<Point>& region, const Plane& plane) {
  std::vector<Point> ends;
  for (std::size_t i = 0; i < region.size(); ++i) {
    const Point &p = region[i], &q = region[(i + 1) % region.size()];
    const double at_p = plane.signed_distance(p), at_q = plane.signed_distance(q);
    if ((at_p > 0) != (at_q > 0)) ends.emplace_back(p + at_p / (at_p - at_q) * (q - p));
  }
  return ends;
}

Point middle_of(const std::vector<Point>& region) {
  Point sum = Point::Zero();
  double area = 0;
  for (std::size_t i = 1; i + 1 < region.size(); ++i) {
    const double part = (region[i] - region[0]).cross(region[i + 1] - region[0]).z();
    sum += part / 3 * (region[0] + region[i] + region[i + 1]);
    area += part;
  }
  return sum / area;
}

std::vector<Point> ring(const Point& center, double radius) {
  std::vector<Point> points;
  for (int i = 0; i <= 48; ++i) {
    const double angle = i * std::acos(-1.0) / 24;
    points.emplace_back(center + radius * Vector(std::cos(angle), std::sin(angle), 0));
  }
  return points;
}

class Picture {
 public:
  explicit Picture(const Moving<Sphere>& ball)
      : triangles_(polygons()),
        tree_(triangles_, BspLimits{0, 64, 16, 8}),
        search_(ball, triangles_, bounds_between({0, 0, 0}, {7, 5, 1})),
        scene_({0, 0}, 0.02) {
    draw(0, {{0, 0, 0}, {6.9, 0, 0}, {6.9, 4.8, 0}, {0, 4.8, 0}}, {}, {11.1, 4.35, 0}, 1.72, true);
    for (const Wall& wall : walls) scene_.line({wall.from, wall.to}, {colour::blue, 4.0}, 4);
    for (std::size_t i = 0; i < walls.size(); ++i) {
      const Vector along = (walls[i].to - walls[i].from).normalized(), across(-along.y(), along.x(), 0);
      const Point middle = 0.5 * (walls[i].from + walls[i].to);
      scene_.arrow(middle, middle - 0.42 * across, {colour::ink, 1.6}, 5);
      scene_.label(std::to_string(i + 1), 0.5 * (walls[i].from + walls[i].to) + 0.2 * across, 0, 0,
                   colour::blue);
    }
    scene_.polygon(ring(ball.shape.center, ball.shape.radius),
                   {colour::amber, 1, false, Pen{colour::orange, 1.2}}, 5);
    scene_.polygon(ring(ball.shape.center + ball.displacement, ball.shape.radius),
                   {colour::amber, 0.4, false, Pen{colour::orange, 1.2}}, 5);
    scene_.arrow(ball.shape.center, ball.shape.center + ball.displacement, {colour::red, 2.4}, 6);
  }
  const figure::Scene& scene() const { return scene_; }

 private:
  // A node and all below it: `part` is empty where the search does not come.
  void draw(std::uint32_t number, const std::vector<Point>& region, const Passage& part, const Point& at,
            double spread, bool reached) {
    const BspTree::Node& node = tree_.node(number);
    if (node.is_leaf()) return draw_leaf(region, at, reached);
    const Sides sides = reached ? search_.sides(*node.plane, part) : Sides{{1, 0}, {1, 0}};
    const Point below_front = at + Vector(-spread, -1.27, 0), below_back = at + Vector(spread, -1.27, 0);
    if (number == 0) {
      scene_.label("+", at + Vector(-0.5 * spread, -0.42, 0), -0.4, 0.4, colour::grey);
      scene_.label("−", at + Vector(0.5 * spread, -0.42, 0), 0.4, 0.4, colour::grey);
    }
    draw_branch(at, below_front, !sides.front.empty());
    draw_branch(at, below_back, !sides.back.empty());
    scene_.line(cut_through(region, *node.plane), {colour::grey, 1.4, true}, 1);
    scene_.polygon(ring(at, 0.27),
                   {colour::paper, 1, false, reached ? Pen{colour::red, 2.2} : Pen{colour::ink, 1.4}}, 3);
    scene_.label(std::to_string(tree_.order()[node.begin] + 1), at, 0, 0, colour::blue);
    draw(node.front, part_of(region, *node.plane, 1), sides.front, below_front, spread / 2,
         !sides.front.empty());
    draw(node.back, part_of(region, *node.plane, -1), sides.back, below_back, spread / 2,
         !sides.back.empty());
  }

  void draw_branch(const Point& from, const Point& to, bool reached) {
    scene_.line({from, to}, reached ? Pen{colour::red, 2.2} : Pen{colour::grey, 1.4}, 2);
  }

  void draw_leaf(const std::vector<Point>& region, const Point& at, bool reached) {
    const std::string letter(1, static_cast<char>('A' + leaves_++));
    scene_.polygon(region, {reached ? colour::floor : colour::mist}, 0);
    scene_.patch(at, {0.24, 0, 0}, {0, 0.24, 0},
                 {reached ? colour::floor : colour::mist, 1, false,
                  reached ? Pen{colour::red, 2.2} : Pen{colour::grey, 1.4}},
                 3);
    scene_.label("{/:Italic " + letter + "}", at);
    scene_.label("{/:Italic " + letter + "}",
                 middle_of(region) + beside_[static_cast<std::size_t>(leaves_ - 1)]);
  }

  std::vector<Triangle> triangles_;
  BspTree tree_;
  NearBall<Triangle> search_;
  figure::Scene scene_;
  int leaves_ = 0;
  // The names of the parts of space, moved from their middles to where nothing else stands.
  std::array<Vector, 6> beside_{Vector(0.9, -0.25, 0), Vector(0.65, 0.1, 0), Vector(0, 0, 0),
                                Vector(0.7, 0, 0),     Vector(0, 0, 0),      Vector(0, 0, 0)};
};

}  // namespace

void draw_bsp(const Studio& studio) {
  const Picture picture(Moving<Sphere>{{{5.6, 2.35, 0}, 0.2}, {-1.7, -0.75, 0}});
  Figure figure(studio, "bsp-tree", picture.scene().size(960));
  picture.scene().draw(figure);
  figure.draw();
}
