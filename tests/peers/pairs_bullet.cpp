// The same with Bullet: btSubsimplexConvexCast for two spheres, and btDbvt as the broad phase about the same
// sweep.

#include <BulletCollision/BroadphaseCollision/btDbvt.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/NarrowPhaseCollision/btSubSimplexConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include "first_contact/batch/batch.hpp"
#include "first_contact/geometry/bounds.hpp"
#include "first_contact/sweep/sphere_sphere.hpp"
#include "peers/pairs.hpp"

using namespace first_contact;
using pairs::Balls;

namespace {

btVector3 bullet(const Vector& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

btTransform at(const Point& p) { return btTransform(btMatrix3x3::getIdentity(), bullet(p)); }

double bullet_time(const Moving<Sphere>& p, const Moving<Sphere>& q) {
  btSphereShape a(static_cast<btScalar>(p.shape.radius)), b(static_cast<btScalar>(q.shape.radius));
  btVoronoiSimplexSolver simplex;
  btSubsimplexConvexCast cast(&a, &b, &simplex);
  btConvexCast::CastResult result;
  const bool hit = cast.calcTimeOfImpact(at(p.shape.center), at(p.shape.center + p.displacement),
                                         at(q.shape.center), at(q.shape.center + q.displacement), result);
  return hit ? static_cast<double>(result.m_fraction) : no_contact;
}

void bullet_spheres(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const Balls p = pairs::balls(count, 1), q = pairs::balls(count, 2);
  std::vector<double> times(count);
  const double ns = pairs::measure(state, [&] {
    for (std::size_t i = 0; i < count; ++i) times[i] = bullet_time(p[i], q[i]);
  });
  state.counters["ns"] = ns / static_cast<double>(count);
  pairs::tell_errors(state, times, p, q);
}
BENCHMARK(bullet_spheres)->Arg(100'000)->UseManualTime();

struct Pairs : btDbvt::ICollide {
  explicit Pairs(const Balls& all) : balls(all) {}
  void Process(const btDbvtNode* a, const btDbvtNode* b) override {
    if (a == b) return;
    const auto [i, j] =
        std::minmax({static_cast<std::size_t>(a->dataAsInt), static_cast<std::size_t>(b->dataAsInt)});
    ++sweeps;
    if (sweep(balls[i], balls[j])) ++contacts;
  }
  const Balls& balls;
  std::size_t sweeps = 0, contacts = 0;
};

void bullet_crowd(benchmark::State& state) {
  const Balls balls = pairs::crowd(static_cast<std::size_t>(state.range(0)));
  Pairs found(balls);
  const double ns = pairs::measure(state, [&] {
    found.sweeps = found.contacts = 0;
    btDbvt tree;
    for (std::size_t i = 0; i < balls.size(); ++i) {
      const Bounds bounds = bounds_of(balls[i].shape, balls[i].displacement);
      btDbvtVolume volume = btDbvtVolume::FromMM(bullet(bounds.min()), bullet(bounds.max()));
      tree.insert(volume, nullptr)->dataAsInt = static_cast<int>(i);
    }
    tree.optimizeTopDown();
    tree.collideTT(tree.m_root, tree.m_root, found);
  });
  state.counters["ns_each"] = ns / static_cast<double>(balls.size());
  state.counters["sweeps"] = static_cast<double>(found.sweeps);
  state.counters["contacts"] = static_cast<double>(found.contacts);
}
BENCHMARK(bullet_crowd)
    ->Arg(1'000)
    ->Arg(10'000)
    ->Arg(100'000)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
