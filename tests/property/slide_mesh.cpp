// Slides in random environments, judged by distances that are computed here, in extended precision and
// without the library's formulas.
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "catch.hpp"
#include "first_contact/response/slide.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "wide.hpp"
//
#include <rapidcheck.h>
#include <rapidcheck/catch.h>

using namespace first_contact;

namespace {

using Real = Wide;
using Position = Eigen::Matrix<Real, 3, 1>;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

Real distance(const Position& p, const Position& a, const Position& b) {
  const Position d = b - a;
  const Real length = d.squaredNorm();
  const Real t = length > 0 ? std::clamp<Real>((p - a).dot(d) / length, 0, 1) : Real(0);
  return (p - a - t * d).norm();
}

Real distance(const Position& p, const Triangle& triangle) {
  const Position a = triangle.a.cast<Real>(), b = triangle.b.cast<Real>(), c = triangle.c.cast<Real>();
  const Real rim = std::min({distance(p, a, b), distance(p, b, c), distance(p, c, a)});
  const Position n = (b - a).cross(c - a);
  const bool above = n.dot((b - a).cross(p - a)) >= 0 && n.dot((c - b).cross(p - b)) >= 0 &&
                     n.dot((a - c).cross(p - c)) >= 0;
  using std::abs;
  return above && n.norm() > 0 ? std::min<Real>(rim, abs(n.dot(p - a)) / n.norm()) : rim;
}

double distance(const Point& p, const Mesh& mesh) {
  Real least = std::numeric_limits<Real>::infinity();
  for (std::size_t i = 0; i < mesh.size(); ++i)
    least = std::min(least, distance(p.cast<Real>(), mesh.triangle(i)));
  return static_cast<double>(least);
}

/// Random scenes from a seed, which RapidCheck prints and shrinks.
class Maker {
 public:
  explicit Maker(unsigned seed) : random_(seed) {}

  unsigned below(unsigned limit) { return static_cast<unsigned>(random_()) % limit; }
  double number() { return std::uniform_real_distribution<double>(-1, 1)(random_); }
  Vector vector() { return {number(), number(), number()}; }
  Eigen::Matrix3d turn() {
    return Eigen::Quaterniond(number(), number(), number(), number()).normalized().toRotationMatrix();
  }

  /// Triangles anywhere, through each other as well.
  Mesh soup() {
    std::vector<Point> vertices;
    std::vector<Mesh::Face> faces;
    for (unsigned i = 0, n = 1 + below(12); i < n; ++i) {
      const Point middle = 3 * vector();
      const double size = 0.2 + 2 * std::abs(number());
      for (int k = 0; k < 3; ++k) vertices.emplace_back(middle + size * vector());
      faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return {std::move(vertices), std::move(faces)};
  }

  /// A landscape, level where `height` is 0, turned by a matrix.
  Mesh landscape(double height, const Eigen::Matrix3d& turned) {
    constexpr unsigned n = 5;
    std::vector<Point> vertices;
    std::vector<Mesh::Face> faces;
    for (unsigned j = 0; j < n; ++j)
      for (unsigned i = 0; i < n; ++i)
        vertices.emplace_back(
            turned * Vector(2.0 * i - 4 + 0.3 * number(), 2.0 * j - 4 + 0.3 * number(), height * number()));
    for (unsigned j = 0; j + 1 < n; ++j)
      for (unsigned i = 0; i + 1 < n; ++i) {
        const unsigned a = j * n + i;
        faces.push_back({a, a + 1, a + n + 1});
        faces.push_back({a, a + n + 1, a + n});
      }
    return {std::move(vertices), std::move(faces)};
  }

  /// Large walls through each other at any angle: creases, acute wedges, corners.
  Mesh walls() {
    std::vector<Point> vertices;
    std::vector<Mesh::Face> faces;
    for (unsigned i = 0; i < 3; ++i) {
      const Vector n = vector().normalized(), u = 6 * n.unitOrthogonal(), v = n.cross(u);
      const Point middle = -1.5 * std::abs(number()) * n;
      for (const auto& [a, b] : {std::pair{-1, -1}, std::pair{1, -1}, std::pair{1, 1}, std::pair{-1, 1}})
        vertices.emplace_back(middle + a * u + b * v);
      faces.push_back({4 * i, 4 * i + 1, 4 * i + 2});
      faces.push_back({4 * i, 4 * i + 2, 4 * i + 3});
    }
    return {std::move(vertices), std::move(faces)};
  }

  Mesh any() {
    switch (below(5)) {
      case 0:
        return soup();
      case 1:
        return landscape(1.5, turn());
      case 2:
        return landscape(0, turn());
      case 3:
        return landscape(0.3, Eigen::Matrix3d::Identity());
      default:
        return walls();
    }
  }

 private:
  std::mt19937 random_;
};

struct Trip {
  Mesh mesh;
  Sphere ball;
  Vector wish;

  double scale() const {
    return std::max({ball.center.lpNorm<Eigen::Infinity>() + wish.lpNorm<Eigen::Infinity>(),
                     largest_coordinate(mesh), ball.radius});
  }
};

Trip random_trip() {
  Maker make(*rc::gen::resize(100, rc::gen::arbitrary<unsigned>()));
  Mesh mesh = make.any();
  const double radius = make.below(3) == 0 ? 0.05 : 0.1 + std::abs(make.number());
  Point start = 3 * make.vector();
  while (distance(start, mesh) <= radius) start = (4 + 2 * radius) * make.vector();
  const Triangle aim = mesh.triangle(make.below(static_cast<unsigned>(mesh.size())));
  const Point target = aim.a + 0.5 * std::abs(make.number()) * (aim.b - aim.a + (aim.c - aim.a));
  const double reach = std::pow(10, -1 + 2 * std::abs(make.number()));
  const Vector wish = make.below(4) == 0 ? Vector(reach * make.vector()) : Vector(reach * (target - start));
  return {std::move(mesh), {start, radius}, wish};
}

void check(const Slide& path, const Trip& trip) {
  const Vector forwards = trip.wish.normalized();
  const double ulp = epsilon * trip.scale(), gap = slide_gap * trip.scale();
  double length = 0;
  for (std::size_t i = 0; i < path.positions.size(); ++i) {
    RC_ASSERT(distance(path.positions[i], trip.mesh) >= trip.ball.radius - 2 * ulp);
    if (i == 0) continue;
    const Vector leg = path.positions[i] - path.positions[i - 1];
    length += leg.norm();
    RC_ASSERT(leg.dot(forwards) >= -2 * gap);
    for (double t = 0.0625; t < 1; t += 0.0625)  // it does not go through anything on its way
      RC_ASSERT(distance(Point(path.positions[i - 1] + t * leg), trip.mesh) >= trip.ball.radius - 2 * ulp);
  }
  RC_ASSERT(length <= trip.wish.norm() + 2 * gap);
}

}  // namespace

TEST_CASE("In any environment a slide never penetrates, never goes through, never back, never too far") {
  rc::prop("frame after frame", [] {
    Trip trip = random_trip();
    const Environment environment(trip.mesh);
    std::size_t contacts = 0;
    for (int frame = 0; frame < 6 && trip.ball.center.norm() < 30; ++frame) {
      const Slide path = slide(Moving<Sphere>{trip.ball, trip.wish}, environment);
      RC_ASSERT(path.ending != Ending::exhausted);
      check(path, trip);
      contacts += path.contacts.size();
      trip.ball.center = path.end();
    }
    RC_CLASSIFY(contacts > 0, "met something");
    RC_CLASSIFY(contacts > 5, "met much");
  });
}

TEST_CASE("A scene turned by a quarter has the path turned by it, but for the gap") {
  rc::prop("so", [] {
    const Trip trip = random_trip();
    const auto turned = [](const Vector& v) { return Vector(-v.y(), v.x(), v.z()); };
    std::vector<Point> vertices;
    for (const Point& vertex : trip.mesh.vertices()) vertices.push_back(turned(vertex));
    const Slide path = slide(Moving<Sphere>{trip.ball, trip.wish}, Environment(trip.mesh));
    const Slide other = slide(Moving<Sphere>{{turned(trip.ball.center), trip.ball.radius}, turned(trip.wish)},
                              Environment(Mesh(vertices, trip.mesh.faces())));
    RC_PRE(path.contacts.size() <= 1);  // beyond that the two may part at the first grazed edge
    RC_ASSERT((other.end() - turned(path.end())).norm() <= 1e-9 * trip.scale());
  });
}

TEST_CASE(
    "Pressed against an environment for many frames a sphere comes to rest, or moves on, and does not "
    "jitter") {
  rc::prop("no step but the first few goes back and forth", [] {
    Trip trip = random_trip();
    const Environment environment(trip.mesh);
    trip.wish *= 0.1 / trip.wish.norm();
    const Vector forwards = trip.wish.normalized();
    for (int frame = 0; frame < 100; ++frame) {
      const Slide path = slide(Moving<Sphere>{trip.ball, trip.wish}, environment);
      RC_ASSERT((path.end() - trip.ball.center).dot(forwards) >= -2 * slide_gap * trip.scale());
      trip.ball.center = path.end();
    }
    RC_ASSERT(distance(trip.ball.center, trip.mesh) >= trip.ball.radius - 2 * epsilon * trip.scale());
  });
}
