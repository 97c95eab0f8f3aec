#include "verify/surfaces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace surfaces {

namespace {

double uniform(Random& random, double low, double high) {
  return low + (high - low) * std::uniform_real_distribution<double>()(random);
}
double log_uniform(Random& random, double low, double high) {
  return std::exp(uniform(random, std::log(low), std::log(high)));
}
Vector inside_cube(Random& random, double size) {
  return {uniform(random, -size, size), uniform(random, -size, size), uniform(random, -size, size)};
}
Vector direction(Random& random) {
  std::normal_distribution<double> normal;
  Vector v(normal(random), normal(random), normal(random));
  return v.normalized();
}

/// Triangles that share no vertex numbers, though some have vertices in the same place.
struct Loose {
  std::vector<Point> points;
  std::vector<Mesh::Face> faces;
  void add(const Point& a, const Point& b, const Point& c) {
    const auto first = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), {a, b, c});
    faces.push_back({first, first + 1, first + 2});
  }
};

Mesh grid(std::uint32_t n, double bumps, Random& random) {
  std::vector<Point> points;
  std::vector<Mesh::Face> faces;
  for (std::uint32_t j = 0; j <= n; ++j)
    for (std::uint32_t i = 0; i <= n; ++i)
      points.emplace_back(2.0 * i / n - 1, 2.0 * j / n - 1, bumps * uniform(random, -1, 1));
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = j * (n + 1) + i, c = a + n + 1;
      faces.push_back({a, a + 1, c + 1});
      faces.push_back({a, c + 1, c});
    }
  return {std::move(points), std::move(faces)};
}

void add_loose(Loose& mesh, int kind, Random& random) {
  const Point a = inside_cube(random, 1), b = a + inside_cube(random, 0.4), c = a + inside_cube(random, 0.4);
  const auto whole = [&] { return Point(inside_cube(random, 3).array().round() / 3); };
  switch (kind) {
    case 2:
      return mesh.add(a, b, c);
    case 3:
      return mesh.add(
          a, b, a + uniform(random, 0, 1) * (b - a) + inside_cube(random, log_uniform(random, 1e-16, 1e-2)));
    case 4:
      mesh.add(a, b, c);
      mesh.add(c, b, a);
      return mesh.add(b, c, a);
    case 5: {
      const Point middle = a + uniform(random, 0, 1) * (b - a), d = a + b - c;
      mesh.add(a, b, c);
      mesh.add(a, middle, d);
      return mesh.add(middle, b, d);
    }
    default:
      return mesh.add(whole(), whole(), whole());
  }
}

/// A fan about the origin, ridges and valleys in turn.
Mesh fan(Random& random) {
  const auto n = 3 + static_cast<std::uint32_t>(random() % 9);
  std::vector<Point> points{Point::Zero()};
  std::vector<Mesh::Face> faces;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * i / n;
    points.emplace_back(std::cos(angle), std::sin(angle), uniform(random, -0.6, 0.6));
    faces.push_back({0, 1 + i, 1 + (i + 1) % n});
  }
  return {std::move(points), std::move(faces)};
}

/// A closed body about the origin: an octahedron of n n triangles a side, blown up to a sphere with bumps.
Mesh closed(Random& random) {
  const auto n = 1 + static_cast<int>(random() % 5);
  const double bumps = random() % 2 ? 0.2 : 0;
  std::map<std::array<int, 3>, std::uint32_t> numbers;
  std::vector<Point> points;
  std::vector<Mesh::Face> faces;
  const auto vertex = [&](int x, int y, int z) {  // |x| + |y| + |z| = n
    const auto [place, is_new] = numbers.try_emplace({x, y, z}, static_cast<std::uint32_t>(points.size()));
    if (is_new) points.emplace_back(Point(x, y, z).normalized() * (1 + bumps * uniform(random, -1, 1)));
    return place->second;
  };
  for (const int sx : {-1, 1})
    for (const int sy : {-1, 1})
      for (const int sz : {-1, 1})
        for (int i = 0; i < n; ++i)
          for (int j = 0; i + j < n; ++j) {
            const auto at = [&](int x, int y) { return vertex(sx * x, sy * y, sz * (n - x - y)); };
            faces.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
            if (i + j + 2 <= n) faces.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
          }
  return {std::move(points), std::move(faces)};
}

/// Up to seven pages at one edge.
Mesh book(Random& random) {
  std::vector<Point> points{{0, 0, -1}, {0, 0, 1}};
  std::vector<Mesh::Face> faces;
  for (auto pages = 1 + static_cast<std::uint32_t>(random() % 7); pages > 0; --pages) {
    const double angle = uniform(random, 0, 6.283185307179586);
    points.emplace_back(std::cos(angle), std::sin(angle), uniform(random, -1, 1));
    const auto last = static_cast<std::uint32_t>(points.size()) - 1;
    faces.push_back(random() % 2 ? Mesh::Face{0, 1, last} : Mesh::Face{last, 1, 0});
  }
  return {std::move(points), std::move(faces)};
}

/// To a corner, a side or the inside of a triangle, nearly along a side as often as not.
Moving<Sphere> flat_cast(const Triangle& t, Random& random) {
  const double size = std::max((t.b - t.a).norm(), (t.c - t.a).norm()) + 1e-300;
  const double r = random() % 2 ? 0 : size * log_uniform(random, 1e-14, 10);
  const double length = size * (random() % 2 ? log_uniform(random, 1e-6, 30) : uniform(random, 0.1, 4));
  const auto part = random() % 3;
  const double u = part == 0 ? 0 : uniform(random, 0, 1), v = part == 2 ? uniform(random, 0, 1 - u) : 0;
  const Point target = t.a + u * (t.b - t.a) + v * (t.c - t.a);

  const Vector n = t.area_vector().stableNormalized(), side = (t.b - t.a).stableNormalized();
  const Vector level = direction(random).cross(n).stableNormalized();
  const bool along = random() % 2 && side.norm() > 0;
  const Vector way = along ? Vector(side + log_uniform(random, 1e-15, 1) * level) : level;
  const double slope = log_uniform(random, 1e-15, 1) * (random() % 2 ? 1 : -1);
  const Vector d = (way - slope * n).stableNormalized(), out = slope > 0 ? n : Vector(-n);
  return {Sphere{target + r * out - uniform(random, -0.1, 1) * length * d, r}, length * d};
}

}  // namespace

const char* name(int kind) {
  constexpr std::array names{"bumpy",       "flat",       "loose", "slivers", "duplicates",
                             "T-junctions", "degenerate", "fan",   "closed",  "book"};
  return names[static_cast<std::size_t>(kind)];
}

Mesh surface(int kind, Random& random) {
  if (kind == 0)
    return grid(2 + static_cast<std::uint32_t>(random() % 12), log_uniform(random, 1e-6, 0.3), random);
  if (kind == 1) return grid(2 + static_cast<std::uint32_t>(random() % 12), 0, random);
  if (kind == 7) return fan(random);
  if (kind == 8) return closed(random);
  if (kind == 9) return book(random);
  Loose mesh;
  for (std::size_t i = 1 + random() % 100; i > 0; --i) add_loose(mesh, kind, random);
  return {std::move(mesh.points), std::move(mesh.faces)};
}

Mesh sliver(Random& random) {
  const Vector x = direction(random), y = x.cross(direction(random)).normalized();
  const double foot = random() % 2 ? uniform(random, -1, 2) : log_uniform(random, 1e-15, 1);
  std::vector<Point> corners{Point::Zero(), x, foot * x + log_uniform(random, 1e-15, 1) * y};
  std::shuffle(corners.begin(), corners.end(), random);
  return {std::move(corners), {{0, 1, 2}}};
}

Mesh placed(const Mesh& mesh, Random& random) {
  const double size = std::pow(10.0, static_cast<double>(random() % 13) - 6);
  const double away = random() % 2 ? 0 : size * std::pow(10.0, static_cast<double>(random() % 4));
  const bool turned = random() % 2;
  const Eigen::AngleAxisd turn(turned ? uniform(random, 0, 3) : 0, direction(random));
  const Vector offset = away * direction(random);
  std::vector<Point> points;
  for (const Point& p : mesh.vertices())
    points.emplace_back((turned ? turn * Vector(size * p) : Vector(size * p)) + offset);
  return {std::move(points), mesh.faces()};
}

const char* aim_name(int aim) {
  constexpr std::array names{"vertex", "edge", "seam", "graze", "anywhere", "overlap", "ray", "flat"};
  return names[static_cast<std::size_t>(aim)];
}

Moving<Sphere> cast(const Mesh& mesh, int aim, Random& random) {
  const Triangle t = mesh.triangle(random() % mesh.size());
  if (aim == flat) return flat_cast(t, random);
  const double size = std::max((t.b - t.a).norm(), (t.c - t.a).norm()) + 1e-300;
  const double wide = size * log_uniform(random, 1e-3, 10), r = aim == 6 ? 0 : wide,
               length = size * log_uniform(random, 1e-2, 30);
  const double u = uniform(random, 0, 1), v = uniform(random, 0, 1 - u);
  const auto part = aim == 6 ? random() % 4 : 0;  // a ray: to a vertex, an edge, and twice as often to a face
  const bool to_vertex = aim == 0 || (aim == 6 && part == 0), to_edge = aim < 4 || (aim == 6 && part == 1);
  const Point target = to_vertex ? t.a
                       : to_edge ? Point(t.a + u * (t.b - t.a))
                                 : Point(t.a + u * (t.b - t.a) + v * (t.c - t.a));
  const Vector d = direction(random), n = t.area_vector().stableNormalized();
  Vector beside = Vector::Zero();
  if (aim == 2) beside = r * (random() % 2 ? n : Vector(-n));  // the lowest point comes down on the seam
  if (aim == 3)  // past it, at a distance of r but for a few roundings, or a little more
    beside = r * (1 + log_uniform(random, 1e-17, 1e-9) * (random() % 2 ? 1 : -1)) *
             d.cross(direction(random)).normalized();
  if (aim == 5) return {Sphere{target + uniform(random, 0, 1) * r * direction(random), r}, length * d};
  return {Sphere{target + beside - uniform(random, -0.1, 1) * length * d, r}, length * d};
}

}  // namespace surfaces
