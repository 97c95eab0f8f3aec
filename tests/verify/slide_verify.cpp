// Slides over real surfaces, frame after frame: ./course verify. Exit status 1 on a fault.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <random>
#include <string>

#include "first_contact/geometry/closest_point.hpp"
#include "first_contact/geometry/mesh_file.hpp"
#include "first_contact/partition/bvh.hpp"
#include "first_contact/response/slide.hpp"
#include "peers/scenes.hpp"

using namespace first_contact;

namespace {

/// What is worst in all frames of a scene, in units of its largest coordinate.
struct Worst {
  double depth = 0;     // of the sphere's surface below the scene's, in the frames that are looked at
  double reversal = 0;  // how far a frame ends behind where it began
  long exhausted = 0;
  long contacts = 0;
  long through = 0;  // frames that end on the wrong side of the surface
  double seconds = 0;
};

double distance_from(const Mesh& mesh, const Point& p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < mesh.size(); ++i)
    least = std::min(least, (closest_point(p, mesh.triangle(i)) - p).squaredNorm());
  return std::sqrt(least);
}

/// Is a centre on the side of the surface where it belongs?
using Side = bool (*)(const Point& center, const Bvh& bvh);

bool hits(const Point& from, const Vector& to, const Bvh& bvh) {
  return sweep({Sphere{from, 0}, to}, bvh).has_value();
}

bool above(const Point& p, const Bvh& bvh) { return hits(p, {0, 0, -1000}, bvh); }

// The faces of a closed surface look outward: what is seen from outside shows its front.
bool outside(const Point& p, const Bvh& bvh) {
  const Vector up(0.1, 0.2, 1000);
  const auto seen = sweep({Sphere{p, 0}, up}, bvh);
  return !seen || bvh.mesh().triangle(seen->triangle).area_vector().dot(up) < 0;
}

bool in_room(const Point& p, const Bvh&) {
  return p.head<2>().lpNorm<Eigen::Infinity>() < 4 && p.z() > 0 && p.z() < 4;
}

// Each frame moves by up to two radii, the same way for some frames, and always a little downwards or to the
// middle, so that the sphere stays at the surface.
Worst run(const Mesh& mesh, const Sphere& first, const Vector& pull, double reach, Side side, long frames) {
  const Bvh bvh{Mesh(mesh)};
  const double size = extent(mesh);
  const SphereSweep first_contact_of = [&](const Moving<Sphere>& part) { return sweep(part, bvh); };
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> any(-1, 1);
  Worst worst;
  Sphere ball = first;
  Vector wish = Vector::Zero();
  const long look = std::max(1L, frames / std::max(1L, 40'000'000 / static_cast<long>(mesh.size())));
  for (long frame = 0; frame < frames; ++frame) {
    if (frame % 50 == 0) {
      const double speed = ball.radius * std::exp2(1 - 10 * std::abs(any(random)));
      wish = speed * (Vector(any(random), any(random), 0.2 * any(random)).normalized() + pull).normalized();
    }
    if ((ball.center - first.center).lpNorm<Eigen::Infinity>() > reach) ball = first;
    const auto begin = std::chrono::steady_clock::now();
    const Slide path = slide({ball, wish}, first_contact_of, size);
    worst.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    worst.reversal = std::max(worst.reversal, -(path.end() - ball.center).dot(wish) / wish.norm() / size);
    worst.exhausted += path.ending == Ending::exhausted;
    worst.contacts += static_cast<long>(path.contacts.size());
    ball.center = path.end();
    worst.through += !side(ball.center, bvh);
    if (frame % look == 0)
      worst.depth = std::max(worst.depth, (ball.radius - distance_from(mesh, ball.center)) / size);
  }
  return worst;
}

bool tell(const char* name, const Mesh& mesh, const Worst& worst, long frames) {
  const bool good = worst.contacts > 0 && worst.through == 0 && worst.depth <= 1e-9 && worst.reversal <= 1e-9;
  std::printf("%-10s %9zu %12.1e %12.1e %9ld %9ld %9ld %9.2f   %s\n", name, mesh.size(), worst.depth,
              worst.reversal, worst.through, worst.contacts, worst.exhausted,
              1e6 * worst.seconds / static_cast<double>(frames), good ? "" : "FAULT");
  return good;
}

Mesh room() {  // a box with a ramp and two steps in it
  std::vector<Point> v;
  std::vector<Mesh::Face> f;
  const auto quad = [&](const Point& a, const Point& b, const Point& c, const Point& d) {
    const auto i = static_cast<std::uint32_t>(v.size());
    v.insert(v.end(), {a, b, c, d});
    f.push_back({i, i + 1, i + 2});
    f.push_back({i, i + 2, i + 3});
  };
  for (const double s : {-4.0, 4.0}) {
    quad({s, -4, 0}, {s, 4, 0}, {s, 4, 4}, {s, -4, 4});
    quad({-4, s, 0}, {4, s, 0}, {4, s, 4}, {-4, s, 4});
  }
  quad({-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0});
  quad({-4, -4, 4}, {4, -4, 4}, {4, 4, 4}, {-4, 4, 4});
  quad({-3, -1, 0}, {0, -1, 1}, {0, 1, 1}, {-3, 1, 0});  // the ramp
  for (const double x : {1.0, 2.0}) {
    quad({x, -4, x - 1}, {x, 4, x - 1}, {x, 4, x - 0.8}, {x, -4, x - 0.8});
    quad({x, -4, x - 0.8}, {x + 1, -4, x - 0.8}, {x + 1, 4, x - 0.8}, {x, 4, x - 0.8});
  }
  return {std::move(v), std::move(f)};
}

Mesh flat_floor(int n) {
  std::vector<Point> v;
  std::vector<Mesh::Face> f;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) v.emplace_back(x * 0.1, y * 0.1, 0);
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const auto a = static_cast<std::uint32_t>(y * (n + 1) + x), b = a + static_cast<std::uint32_t>(n) + 1;
      f.push_back({a, a + 1, b + 1});
      f.push_back({a, b + 1, b});
    }
  return {std::move(v), std::move(f)};
}

// How far the centre's height changes along a flat floor.
bool drift() {
  const Bvh bvh{flat_floor(100)};
  Sphere ball{{1, 1, 0.31}, 0.3};
  double lowest = 1, highest = 0;
  for (int frame = 0; frame < 2000; ++frame) {
    ball.center = slide(
                      {ball, {0.0037, 0.0031, -0.01}}, [&](const auto& m) { return sweep(m, bvh); }, 10)
                      .end();
    if (frame < 5) continue;
    lowest = std::min(lowest, ball.center.z());
    highest = std::max(highest, ball.center.z());
  }
  std::printf("drift on a flat floor: %.1e (below 1e-12)\n", highest - lowest);
  return highest - lowest < 1e-12;
}

// How far a ball still moves that is pushed into a wedge of 30 degrees.
bool jitter() {
  const double half = std::numbers::pi / 12, c = 9 * std::cos(half), s = 9 * std::sin(half);
  const Bvh bvh{Mesh({{0, 0, -9}, {0, 0, 9}, {c, s, 9}, {c, s, -9}, {c, -s, 9}, {c, -s, -9}},
                     {{0, 1, 2}, {0, 2, 3}, {0, 1, 4}, {0, 4, 5}})};
  Sphere ball{{5, 0.1, 0}, 0.3};
  double most = 0;
  for (int frame = 0; frame < 300; ++frame) {
    const Point before = ball.center;
    ball.center = slide(
                      {ball, {-0.2, 0.03, 0}}, [&](const auto& m) { return sweep(m, bvh); }, 9)
                      .end();
    if (frame > 100) most = std::max(most, (ball.center - before).norm());
  }
  std::printf("jitter in a wedge of 30 degrees: %.1e (below 1e-9)\n", most);
  return most < 1e-9;
}

}  // namespace

int main(int argc, char** argv) {
  const long frames = argc > 1 ? std::atol(argv[1]) : 1'000'000;
  if (frames < 1) return std::fputs("slide_verify [FRAMES]: must be at least 1\n", stderr), 2;
  std::printf("%-10s %9s %12s %12s %9s %9s %9s %9s   %ld frames each\n", "scene", "triangles", "depth",
              "reversal", "through", "contacts", "exhausted", "us a step", frames);
  const Mesh terrain = scenes::terrain(100), bunny = read_mesh(FIRST_CONTACT_DATA "/bunny.off");
  double top = 0;
  for (const Point& p : terrain.vertices()) top = std::max(top, p.z());
  Point middle = Point::Zero();
  for (const Point& p : terrain.vertices()) middle += p / static_cast<double>(terrain.vertices().size());
  bool good = true;
  const auto scene = [&](const char* name, const Mesh& mesh, const Sphere& ball, const Vector& pull,
                         double far, Side side) {
    good = tell(name, mesh, run(mesh, ball, pull, far, side, frames), frames) && good;
  };
  scene("terrain", terrain, {{middle.x(), middle.y(), top + 1}, 0.4}, {0, 0, -0.6}, 28, above);
  scene("bunny", bunny, {{4, -1.2, 9}, 0.5}, {-0.3, 0, -0.5}, 6, outside);
  scene("room", room(), {{-3.5, -3, 1}, 0.3}, {0, 0, -0.3}, 9, in_room);
  good = drift() && good;
  good = jitter() && good;
  return good ? 0 : 1;
}
