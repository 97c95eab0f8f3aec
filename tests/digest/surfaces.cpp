#include "first_contact/bvh/bvh.hpp"
#include "first_contact/response/slide.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "first_contact/sweep/sphere_plane.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"
#include "first_contact/trees/box_tree.hpp"
#include "first_contact/trees/brute_force.hpp"
#include "first_contact/trees/bsp_tree.hpp"
#include "first_contact/trees/objects.hpp"
#include "first_contact/trees/octree.hpp"
#include "first_contact/trees/plain_bvh.hpp"
#include "first_contact/trees/soup.hpp"
#include "record.hpp"
#include "shapes.hpp"

/// Surfaces of many triangles, the trees that find them, and the slide.
namespace digest {

namespace {

constexpr int scenes = 50, casts = cases / scenes;

/// Toward a vertex, a place of an edge, or anywhere.
Moving<Sphere> ball_at(Dice& dice, const Mesh& mesh, double unit) {
  const Triangle face = mesh.triangle(dice.bits() % mesh.size());
  switch (dice.pick(3)) {
    case 0:
      return ball(dice, unit);
    case 1:
      return grazing_ball(dice, face.a, unit);
    default:
      return grazing_ball(dice, face.b + dice.whole(1, 7) / 8.0 * (face.c - face.b), unit);
  }
}

/// The same questions to an environment and to the fast tree: the same answers, so the same number.
template <class Surface>
void cast_at(Record& record) {
  Dice dice(10);
  for (int scene = 0; scene < scenes; ++scene) {
    const double unit = dice.scale();
    const Mesh mesh = ground(dice, dice.whole(1, 6), unit);
    const Surface surface(mesh);
    for (int i = 0; i < casts; ++i, record.next()) record.add(sweep(ball_at(dice, mesh, unit), surface));
  }
}

/// Casts of points, and whether balls and points overlap the surface.
template <class Surface>
void points_and_overlaps(Record& record) {
  Dice dice(14);
  for (int scene = 0; scene < scenes; ++scene) {
    const double unit = dice.scale();
    const Mesh mesh = ground(dice, dice.whole(1, 6), unit);
    const Surface surface(mesh);
    for (int i = 0; i < casts / 2; ++i, record.next()) {
      const Moving<Sphere> mover = ball_at(dice, mesh, unit);
      record.add(sweep(Moving<Point>{mover.shape.center, mover.displacement}, surface));
      record.add(overlap(mover.shape, surface));
      record.add(overlap(Point(0.5 * mesh.triangle(0).a + 0.5 * mesh.triangle(0).b), surface));
    }
  }
}

void casts_in_turns(Record& record) {
  Dice dice(10);
  for (int scene = 0; scene < scenes; ++scene) {
    const double unit = dice.scale();
    const Mesh mesh = ground(dice, dice.whole(1, 6), unit);
    std::vector<Moving<Sphere>> balls;
    for (int i = 0; i < casts; ++i) balls.push_back(ball_at(dice, mesh, unit));
    std::vector<std::optional<Contact>> first(balls.size());
    sweep(std::span<const Moving<Sphere>>(balls), Bvh(mesh), first);
    for (const auto& contact : first) {
      record.add(contact);
      record.next();
    }
  }
}

/// The same questions to every tree.
template <class Tree>
void ask_soup(Record& record) {
  Dice dice(11);
  for (int scene = 0; scene < scenes; ++scene) {
    const double unit = dice.scale();
    const Soup<Tree> triangles(soup(dice, dice.whole(1, 40), unit));
    for (int i = 0; i < casts; ++i, record.next()) {
      const Moving<Sphere> mover = ball(dice, unit);
      record.add(sweep(mover, triangles));
      record.add(near(mover, triangles));
      record.add(near(bounds_of(mover.shape), triangles));
    }
  }
}

template <class Tree>
void ask_objects(Record& record) {
  Dice dice(12);
  for (int scene = 0; scene < scenes; ++scene, record.next()) {
    const double unit = dice.scale();
    std::vector<Bounds> all;
    for (int i = 0; i < 100; ++i) all.push_back(bounds_of(ball(dice, unit / 2).shape));
    const Objects<Tree> objects(all);
    for (const auto& [i, j] : pairs(objects)) {
      record.count(i);
      record.count(j);
    }
    for (int i = 0; i < 20; ++i) record.add(near(ball(dice, unit), objects));
  }
}

void add(Record& record, const Slide& slide) {
  for (const Point& corner : slide.positions) record.add(corner);
  for (const Contact& contact : slide.contacts) record.add(contact);
  record.count(static_cast<std::size_t>(slide.ending));
  record.next();
}

void slides(Record& record) {
  Dice dice(13);
  for (int scene = 0; scene < scenes; ++scene) {
    const double unit = dice.scale();
    const Environment hills(ground(dice, dice.whole(1, 4), unit));
    const Plane wall = plane(dice, unit);
    const Triangle face = triangle(dice, unit);
    for (int i = 0; i < casts / 4; ++i) {
      add(record, slide(ball_at(dice, hills.mesh(), unit), hills));
      add(record, slide(ball(dice, unit), wall));
      add(record, slide(ball(dice, unit), face));
    }
  }
}

}  // namespace

std::vector<Verb> surface_verbs() {
  return {{"sweep sphere environment", cast_at<Environment>},
          {"sweep sphere plain tree", cast_at<PlainBvh>},
          {"sweep sphere fast tree", cast_at<Bvh>},
          {"sweep spheres in turns", casts_in_turns},
          {"point environment", points_and_overlaps<Environment>},
          {"point plain tree", points_and_overlaps<PlainBvh>},
          {"point fast tree", points_and_overlaps<Bvh>},
          {"ask soup brute force", ask_soup<BruteForce>},
          {"ask soup octree", ask_soup<Octree>},
          {"ask soup BSP tree", ask_soup<BspTree>},
          {"ask soup box tree", ask_soup<BoxTree>},
          {"ask objects octree", ask_objects<Octree>},
          {"ask objects box tree", ask_objects<BoxTree>},
          {"slide", slides}};
}

}  // namespace digest
