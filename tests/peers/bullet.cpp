// Bullet's convexSweepTest of a sphere against a quantized tree of triangles, as its manual advises. Single
// precision.
#include <btBulletCollisionCommon.h>

#include "peers/ways.hpp"

namespace {

using namespace peers;

btVector3 bt(const Vector& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

/// A world with nothing in it but the mesh.
struct World {
  explicit World(const Mesh& mesh) : corners(3 * mesh.vertices().size()), numbers(3 * mesh.size()) {
    for (std::size_t i = 0; i < corners.size(); ++i)
      corners[i] = static_cast<btScalar>(mesh.vertices()[i / 3][static_cast<Eigen::Index>(i % 3)]);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      numbers[i] = static_cast<int>(mesh.faces()[i / 3][i % 3]);
    triangles.addIndexedMesh(described(mesh));
    shape = std::make_unique<btBvhTriangleMeshShape>(&triangles, true);
    object.setCollisionShape(shape.get());
    world.addCollisionObject(&object);
  }

  double sweep(const Moving<Sphere>& moving) const {
    const btSphereShape sphere(static_cast<btScalar>(moving.shape.radius));
    const btVector3 from = bt(moving.shape.center), to = bt(moving.shape.center + moving.displacement);
    btCollisionWorld::ClosestConvexResultCallback found(from, to);
    const btQuaternion upright = btQuaternion::getIdentity();
    world.convexSweepTest(&sphere, btTransform(upright, from), btTransform(upright, to), found);
    return found.hasHit() ? static_cast<double>(found.m_closestHitFraction) : never;
  }

 private:
  btIndexedMesh described(const Mesh& mesh) {
    btIndexedMesh part;
    part.m_numTriangles = static_cast<int>(mesh.size());
    part.m_triangleIndexBase = reinterpret_cast<const unsigned char*>(numbers.data());
    part.m_triangleIndexStride = 3 * sizeof(int);
    part.m_numVertices = static_cast<int>(mesh.vertices().size());
    part.m_vertexBase = reinterpret_cast<const unsigned char*>(corners.data());
    part.m_vertexStride = 3 * sizeof(btScalar);
    return part;
  }

  std::vector<btScalar> corners;
  std::vector<int> numbers;
  btTriangleIndexVertexArray triangles;
  std::unique_ptr<btBvhTriangleMeshShape> shape;
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btCollisionObject object;
  btCollisionWorld world{&dispatcher, &broadphase, &configuration};
};

const Entry entry([](const Mesh& mesh) {
  const auto world = std::make_shared<const World>(mesh);
  return one_by_one("Bullet", [world](const auto& cast) { return world->sweep(cast); });
});

}  // namespace
