// Laws that hold for every sphere and every mesh, on random ones; a failure prints the seed that reproduces
// it.
#include <cmath>
#include <numeric>
#include <random>

#include "catch.hpp"
#include "chance.hpp"
#include "first_contact/geometry/closest_point.hpp"
#include "first_contact/sweep/ray_triangle.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"
#include "test_meshes.hpp"

using namespace first_contact;

namespace {

struct Scene {
  Mesh mesh;
  Moving<Sphere> moving;
};

class Random : public Chance {
 public:
  using Chance::Chance;

  /// Where a sphere would touch the mesh at a face, an edge or a vertex, and a path that leads there.
  Moving<Sphere> cast_at(const Mesh& mesh) {
    const Triangle t = mesh.triangle(pick(mesh.size()));
    const double u = uniform(0, 1), v = uniform(0, 1 - u), radius = std::pow(10, uniform(-2, 0.3));
    const std::array<Point, 3> targets{t.a + u * (t.b - t.a) + v * (t.c - t.a), t.a + u * (t.b - t.a), t.a};
    const Vector displacement = uniform(0.5, 6) * direction();
    return {{targets[pick(3)] + radius * direction() - uniform(0, 1.5) * displacement, radius}, displacement};
  }
  Scene scene() {
    const double crumple = uniform(0, 0.7);
    const Mesh plain = pick(2) == 0 ? test_meshes::cube() : test_meshes::tiled_floor(3);
    Mesh mesh = test_meshes::mapped(plain, [&](const Point& p) { return Point(p + crumple * direction()); });
    const Moving<Sphere> moving = cast_at(mesh);
    return {std::move(mesh), moving};
  }
  Mesh shuffled(const Mesh& mesh) {
    std::vector<Mesh::Face> faces = mesh.faces();
    shuffle(faces);
    return {mesh.vertices(), faces};
  }
};

/// Calls law(random) with 400 seeds, and prints the one that breaks it.
template <class Law>
void for_many_seeds(const Law& law) {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    law(random);
  }
}

void check_same(const std::optional<Contact>& a, const std::optional<Contact>& b) {
  REQUIRE(a.has_value() == b.has_value());
  if (!a) return;
  CHECK(a->time == b->time);
  CHECK(a->point() == b->point());
  CHECK(a->normal == b->normal);
  CHECK(a->feature == b->feature);
}

}  // namespace

TEST_CASE("The answer does not depend on the order of the triangles") {
  for_many_seeds([](Random& random) {
    const Scene scene = random.scene();
    const Mesh shuffled = random.shuffled(scene.mesh);
    const auto a = sweep(scene.moving, Environment(scene.mesh)),
               b = sweep(scene.moving, Environment(shuffled));
    check_same(a, b);
    if (!a) return;
    const auto reached = [&](const Mesh& mesh, std::size_t i) {
      return (closest_point(a->point(), mesh.triangle(i)) - a->point()).norm() < 1e-12;
    };
    CHECK(reached(scene.mesh, a->triangle));
    CHECK(reached(shuffled, b->triangle));
  });
}

TEST_CASE("A mesh without shared vertices is the same surface") {
  for_many_seeds([](Random& random) {
    const Scene scene = random.scene();
    check_same(sweep(scene.moving, Environment(scene.mesh)),
               sweep(scene.moving, Environment(test_meshes::unwelded(scene.mesh))));
  });
}

TEST_CASE("A scene that is scaled by a power of two has the same times and normals, bit for bit") {
  for_many_seeds([](Random& random) {
    const Scene scene = random.scene();
    const auto contact = sweep(scene.moving, Environment(scene.mesh));
    for (const double scale : {std::ldexp(1.0, -100), 8.0, std::ldexp(1.0, 100)}) {
      const Mesh mesh = test_meshes::mapped(scene.mesh, [&](const Point& p) { return Point(scale * p); });
      const Sphere sphere{scale * scene.moving.shape.center, scale * scene.moving.shape.radius};
      const auto scaled = sweep(Moving<Sphere>{sphere, scale * scene.moving.displacement}, Environment(mesh));
      REQUIRE(scaled.has_value() == contact.has_value());
      if (!contact) continue;
      CHECK(scaled->time == contact->time);
      CHECK(scaled->normal == contact->normal);
      CHECK(scaled->point() == scale * contact->point());
      CHECK(scaled->feature == contact->feature);
      CHECK(scaled->triangle == contact->triangle);
    }
  });
}

TEST_CASE("At a contact the sphere touches the surface, approaching, and does not touch it before") {
  for_many_seeds([](Random& random) {
    const Scene scene = random.scene();
    const auto contact = sweep(scene.moving, Environment(scene.mesh));
    if (!contact) return;
    const auto& [sphere, displacement] = scene.moving;
    CHECK(contact->normal.norm() == Approx(1).epsilon(1e-15));
    CHECK(contact->normal.dot(displacement) < 0);
    if (contact->time == 0) return;
    const Point center = sphere.center + contact->time * displacement;
    CHECK((center - sphere.radius * contact->normal - contact->point()).norm() < 1e-12);
    if (overlap(sphere, scene.mesh)) return;
    for (int i = 0; i < 50; ++i) {
      const double t = contact->time * (i / 50.0);
      CHECK_FALSE(overlap(Sphere{sphere.center + t * displacement, sphere.radius * (1 - 1e-12)}, scene.mesh));
    }
  });
}

TEST_CASE("A mesh of one triangle is that triangle") {
  for_many_seeds([](Random& random) {
    const Triangle triangle{random.direction(), random.direction(), random.direction()};
    const Mesh mesh{{triangle.a, triangle.b, triangle.c}, {{0, 1, 2}}};
    for (int i = 0; i < 10; ++i) {
      const Moving<Sphere> moving = random.cast_at(mesh);
      const auto one = sweep(moving, triangle), all = sweep(moving, Environment(mesh));
      REQUIRE(one.has_value() == all.has_value());
      if (!one) continue;
      CHECK(one->time == Approx(all->time).margin(1e-14));
      CHECK((one->normal - all->normal).norm() < 1e-12);
      CHECK(one->feature == all->feature);
    }
  });
}

TEST_CASE("A ray is a sphere of radius 0, and nearly one of a tiny radius") {
  for_many_seeds([](Random& random) {
    const Triangle triangle{random.direction(), random.direction(), random.direction()};
    const Point start = 2 * random.direction();
    const Vector displacement = random.uniform(1, 5) * random.direction();
    const auto ray = sweep(Moving<Point>{start, displacement}, triangle);
    check_same(ray, sweep(Moving<Sphere>{{start, 0}, displacement}, triangle));
    if (!ray || std::abs(ray->normal.dot(displacement)) < 1e-3) return;
    const auto ball = sweep(Moving<Sphere>{{start, 1e-9}, displacement}, triangle);
    REQUIRE(ball);
    CHECK(ball->time == Approx(ray->time).margin(1e-5));
  });
}

TEST_CASE("No ray slips through a seam or a vertex of a closed surface") {
  for_many_seeds([](Random& random) {
    const Eigen::AngleAxisd turn(random.uniform(0, 3), random.direction());
    const Vector shift = std::pow(10, random.uniform(-3, 6)) * random.direction();
    const Mesh cube =
        test_meshes::mapped(test_meshes::cube(), [&](const Point& p) { return Point(turn * p + shift); });
    const Triangle t = cube.triangle(random.pick(cube.size()));
    const Point target = random.pick(2) == 0 ? t.a : Point(t.a + random.uniform(0, 1) * (t.b - t.a));
    const Vector outward = target - shift;  // from the centre, which the cube hides from every side
    bool met = false;
    for (std::size_t i = 0; i < cube.size(); ++i)
      met = met || sweep(Moving<Point>{shift + 2 * outward, -1.5 * outward}, cube.triangle(i));
    CHECK(met);
    CHECK(sweep(Moving<Sphere>{{shift + 2 * outward, 0}, -1.5 * outward}, Environment(cube)));
  });
}

TEST_CASE("A tilted floor of many tiles is all face, wherever a sphere comes down on it") {
  for_many_seeds([](Random& random) {
    const Eigen::AngleAxisd turn(random.uniform(0, 3), random.direction());
    const Mesh floor =
        test_meshes::mapped(test_meshes::tiled_floor(4), [&](const Point& p) { return Point(turn * p); });
    const Environment environment(floor);
    const double radius = std::pow(10, random.uniform(-2, 2));
    for (const Point& p : {Point(2, 2, 0), Point(1.5, 1.5, 0), Point(2, 1.3, 0), Point(3, 1, 0)}) {
      const Vector path{random.uniform(-2, 2), random.uniform(-2, 2), -2};
      const Point start = p + Vector(0, 0, radius) - 0.5 * path;
      const auto contact = sweep(Moving<Sphere>{{turn * start, radius}, turn * path}, environment);
      REQUIRE(contact);
      CHECK(contact->feature == Feature::face);
      CHECK(contact->time == Approx(0.5).epsilon(1e-12));
      CHECK((contact->normal - turn * Vector(0, 0, 1)).norm() < 1e-14);
    }
  });
}

TEST_CASE(
    "An overlap at the start is judged feature by feature: by the nearest of each face, edge and vertex") {
  for_many_seeds([](Random& random) {
    const Scene scene = random.scene();
    const Sphere& sphere = scene.moving.shape;
    const Vector& displacement = scene.moving.displacement;
    const Environment environment(scene.mesh);
    const auto contact = sweep(scene.moving, environment);
    bool deeper = false;
    bool unsure = false;
    const auto judge = [&](const Point& nearest) {
      const double toward = (sphere.center - nearest).dot(displacement);
      deeper = deeper || toward < 0;
      unsure = unsure || std::abs(toward) < 1e-6;
    };
    for (std::size_t i = 0; i < scene.mesh.size();
         ++i) {  // the faces and edges that are nearest of all around them
      const Triangle t = scene.mesh.triangle(i);
      const Point q = closest_point(sphere.center, t);
      const double distance = (q - sphere.center).norm();
      if (distance > sphere.radius) continue;
      bool nearest = true;
      for (std::size_t j = 0; j < scene.mesh.size(); ++j) {
        const Triangle other = scene.mesh.triangle(j);
        if ((closest_point(q, other) - q).norm() > 1e-9) continue;  // does not share this point
        nearest = nearest && (closest_point(sphere.center, other) - sphere.center).norm() > distance - 1e-9;
      }
      if (nearest) judge(q);
    }
    if (!unsure) CHECK((contact && contact->time == 0) == deeper);
  });
}
