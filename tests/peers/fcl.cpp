// FCL's continuousCollide of a sphere with a tree of oriented boxes, with its default request. Double
// precision.
#include <fcl/fcl.h>

#include "peers/ways.hpp"

namespace {

using namespace peers;
using Tree = fcl::BVHModel<fcl::OBBRSSd>;

std::shared_ptr<const Tree> tree_of(const Mesh& mesh) {
  std::vector<fcl::Triangle> triangles;
  for (const auto& [a, b, c] : mesh.faces()) triangles.emplace_back(a, b, c);
  const auto tree = std::make_shared<Tree>();
  tree->beginModel();
  tree->addSubModel(mesh.vertices(), triangles);
  tree->endModel();
  return tree;
}

double sweep(const Moving<Sphere>& moving, const Tree& tree) {
  const fcl::Sphered sphere(moving.shape.radius);
  const fcl::Transform3d at_rest = fcl::Transform3d::Identity();
  const fcl::Transform3d from(Eigen::Translation3d(moving.shape.center));
  const fcl::Transform3d to(Eigen::Translation3d(moving.shape.center + moving.displacement));
  fcl::ContinuousCollisionResultd result;
  fcl::continuousCollide(&sphere, from, to, &tree, at_rest, at_rest, fcl::ContinuousCollisionRequestd(),
                         result);
  return result.is_collide ? result.time_of_contact : never;
}

const Entry entry([](const Mesh& mesh) {
  const auto tree = tree_of(mesh);
  Way way = one_by_one("FCL", [tree](const auto& cast) { return sweep(cast, *tree); });
  way.most_triangles = 200'000;
  return way;
});

}  // namespace
