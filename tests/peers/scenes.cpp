#include "peers/scenes.hpp"

#include <cmath>

namespace scenes {

namespace {

using Random = std::mt19937_64;

double uniform(Random& random, double low, double high) {
  return low + (high - low) * std::uniform_real_distribution<double>()(random);
}
double log_uniform(Random& random, double low, double high) {
  return std::exp(uniform(random, std::log(low), std::log(high)));
}
Vector direction(Random& random) {
  std::normal_distribution<double> normal;
  const Vector v(normal(random), normal(random), normal(random));
  return v.norm() > 0 ? Vector(v.normalized()) : Vector(Vector::UnitX());
}
double unit_weight(Random& random) { return uniform(random, 0, 1); }

/// A point of the surface, most often of a face; for aimed casts a vertex or a point of an edge.
Point target(const Mesh& mesh, Random& random, bool aimed) {
  const Triangle t = mesh.triangle(random() % mesh.size());
  if (aimed && random() % 2) return t.a;
  double u = unit_weight(random), v = aimed ? 0 : unit_weight(random);
  if (u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  return t.a + u * (t.b - t.a) + v * (t.c - t.a);
}

Moving<Sphere> cast(const Mesh& mesh, Kind kind, Random& random, double unit) {
  const double r = unit * log_uniform(random, 0.01, 0.5);
  const bool aimed = kind == Kind::aimed;
  const Point p = target(mesh, random, aimed);
  const Vector d = direction(random);
  if (aimed) {  // at the target, or past it at a distance of just about r
    const double length = unit * log_uniform(random, 1, 8);
    const Vector beside =
        random() % 4 ? Vector(Vector::Zero()) : Vector(r * d.cross(direction(random)).normalized());
    const double part = uniform(random, 0.3, 0.9);
    return {Sphere{p + beside - part * length * d, r}, length * d};
  }
  const double length = kind == Kind::micro ? r * log_uniform(random, 1e-3, 1)
                        : kind == Kind::hop ? unit * log_uniform(random, 0.05, 0.5)
                                            : unit * log_uniform(random, 5, 60);
  const Vector away(0, 0, 1);  // start above the surface, apart from it more often than not
  const double height =
      r * uniform(random, 0.8, 1.5) + (kind == Kind::length ? unit * uniform(random, 0, 4) : 0);
  Vector v = d;
  if (v.z() > 0 && random() % 4) v.z() = -v.z();
  return {Sphere{p + height * away, r}, length * v};
}

}  // namespace

const char* to_string(Kind kind) {
  switch (kind) {
    case Kind::micro:
      return "micro";
    case Kind::hop:
      return "hop";
    case Kind::length:
      return "long";
    case Kind::aimed:
      return "aimed";
  }
  return "";
}

std::vector<Moving<Sphere>> casts(const Mesh& mesh, Kind kind, std::size_t count, std::uint64_t seed,
                                  double unit) {
  Random random(seed);
  std::vector<Moving<Sphere>> result;
  result.reserve(count);
  for (std::size_t i = 0; i < count; ++i) result.push_back(cast(mesh, kind, random, unit));
  return result;
}

}  // namespace scenes
