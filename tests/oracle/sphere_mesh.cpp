#include "first_contact/sweep/sphere_mesh.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <sstream>

#include "catch.hpp"
#include "chance.hpp"
#include "exact_triangle.hpp"
#include "test_meshes.hpp"

using namespace first_contact;

namespace {

/// A crumpled ball, a crumpled floor, a saddle, a turned cube, or loose triangles.
Mesh random_mesh(Chance& random) {
  const auto crumple = [&](double by) {
    return [&random, by](const Point& p) { return Point(p + by * random.direction()); };
  };
  switch (random.pick(5)) {
    case 0:
      return test_meshes::mapped(test_meshes::cube(), crumple(random.uniform(0, 0.8)));
    case 1:
      return test_meshes::mapped(test_meshes::tiled_floor(3), crumple(std::pow(10, random.uniform(-17, -1))));
    case 2:
      return test_meshes::fan({0.5, -0.4, random.uniform(-1, 1), -0.6, random.uniform(-1, 1)});
    case 3: {
      const Eigen::AngleAxisd turn(random.uniform(0, 3), random.direction());
      return test_meshes::mapped(test_meshes::cube(), [&](const Point& p) { return Point(turn * p); });
    }
    default: {
      std::vector<Point> vertices;
      std::vector<Mesh::Face> faces;
      for (std::uint32_t i = 0; i < 8; ++i) {
        for (int corner = 0; corner < 3; ++corner) vertices.push_back(random.direction());
        faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
      }
      return {vertices, faces};
    }
  }
}

/// A sphere on its way to touch a face, an edge or a vertex, squarely or barely.
Moving<Sphere> aimed_cast(Chance& random, const Mesh& mesh) {
  const Triangle t = mesh.triangle(random.pick(mesh.size()));
  const double u = random.uniform(0, 1), v = random.uniform(0, 1 - u),
               radius = std::pow(10, random.uniform(-3, 0.5));
  const std::array<Point, 3> targets{Point(t.a + u * (t.b - t.a) + v * (t.c - t.a)),
                                     Point(t.a + u * (t.b - t.a)), t.a};
  const Vector away = random.pick(2) == 0 ? Vector(t.area_vector().normalized()) : random.direction();
  const double slope = std::array<double, 3>{1, 1e-5, 0}[random.pick(3)] * random.uniform(0, 1);
  const Vector displacement = random.uniform(0.1, 6) * (away.cross(random.direction()) - slope * away);
  return {{targets[random.pick(3)] + radius * away - random.uniform(0, 1.1) * displacement, radius},
          displacement};
}

std::string text(const Mesh& mesh, const Moving<Sphere>& moving) {
  std::ostringstream out;
  out << std::hexfloat << "sphere {" << moving.shape.center.transpose() << "} radius " << moving.shape.radius
      << " displacement {" << moving.displacement.transpose() << "} triangles";
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const Triangle t = mesh.triangle(i);
    out << "\n  {" << t.a.transpose() << "} {" << t.b.transpose() << "} {" << t.c.transpose() << "}";
  }
  return out.str();
}

/// The earliest of the exact times of all triangles, for one radius.
std::optional<oracle::Real> first_time(const std::vector<oracle::Approach>& approaches,
                                       const oracle::Real& radius) {
  std::optional<oracle::Real> first;
  for (const oracle::Approach& approach : approaches)
    if (const auto t = approach.first_time(radius); t && (!first || *t < *first)) first = t;
  return first;
}

double bound(const Mesh& mesh, const Moving<Sphere>& moving) {
  double corner = 0, side = 0;
  for (const Point& p : mesh.vertices()) corner = std::max(corner, (p - moving.shape.center).norm());
  for (std::size_t i = 0; i < mesh.size(); ++i) side = std::max(side, Facet(mesh.triangle(i)).longest);
  return 16 * std::numeric_limits<double>::epsilon() *
         (corner + side + moving.displacement.norm() + moving.shape.radius);
}

}  // namespace

TEST_CASE(
    "The first time of a sphere and a mesh is the earliest exact time of its triangles, within the bound") {
  Chance random(20240601);
  int hits = 0;
  for (int i = 0; i < 600; ++i) {
    const Mesh mesh = random_mesh(random);
    const Moving<Sphere> moving = aimed_cast(random, mesh);
    INFO("cast " << i << ": " << text(mesh, moving));
    const double delta = bound(mesh, moving);
    std::vector<oracle::Approach> approaches;
    for (std::size_t j = 0; j < mesh.size(); ++j)
      approaches.emplace_back(mesh.triangle(j), moving.shape.center, moving.displacement);
    const oracle::Real radius = moving.shape.radius;
    const auto earliest = first_time(approaches, radius + delta),
               latest = first_time(approaches, radius - delta);
    if (earliest && *earliest == 0) continue;  // touching at the start: judged by its own tests

    const auto contact = sweep(moving, Environment(mesh));
    hits += contact.has_value();
    if (latest) REQUIRE(contact);  // never a miss
    if (!contact) continue;
    REQUIRE(earliest);  // never an invention
    constexpr double rounding_of_t = std::numeric_limits<double>::epsilon();
    CHECK(contact->time >= static_cast<double>(*earliest) * (1 - rounding_of_t));
    if (latest) CHECK(contact->time <= static_cast<double>(*latest) * (1 + rounding_of_t));
    CHECK(contact->triangle < mesh.size());
  }
  CHECK(hits > 200);
}

namespace {

/// The distance from a mesh at one time: the smallest over all triangles.
double distance_at(const Mesh& mesh, const Moving<Sphere>& moving, double t) {
  const Point p = moving.shape.center + t * moving.displacement;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const oracle::Exact q = oracle::ExactTriangle(mesh.triangle(i)).nearest(oracle::exact(p));
    const oracle::Exact w = oracle::difference(q, oracle::exact(p));
    least = std::min(least, static_cast<double>(sqrt(oracle::dot(w, w))));
  }
  return least;
}

}  // namespace

TEST_CASE("Dense sampling and bisection find the same first time as a sweep of a mesh") {
  Chance random(7);
  for (int i = 0; i < 25; ++i) {
    const Mesh mesh = random_mesh(random);
    const Moving<Sphere> moving = aimed_cast(random, mesh);
    if (distance_at(mesh, moving, 0) <= moving.shape.radius * (1 + 1e-9)) continue;
    const double radius = moving.shape.radius - 1e-12;  // what is no deeper may be rounding
    INFO("cast " << i << ": " << text(mesh, moving));
    const auto contact = sweep(moving, Environment(mesh));
    constexpr int samples = 100;
    for (int k = 1; k <= samples; ++k) {
      double from = double(k - 1) / samples, to = double(k) / samples;
      if (distance_at(mesh, moving, to) > radius) continue;
      while (to - from > 1e-12) {
        const double middle = (from + to) / 2;
        (distance_at(mesh, moving, middle) <= radius ? to : from) = middle;
      }
      REQUIRE(contact);  // what is found between samples may only come earlier
      CHECK(contact->time <= to + 1e-9);
      if (contact->time < from - 1e-9)
        CHECK(distance_at(mesh, moving, contact->time) == Approx(radius).margin(1e-9));
      break;
    }
  }
}
