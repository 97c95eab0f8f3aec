// The range of numbers that contact.hpp promises, at its ends: a scene multiplied by a power of two has the same
// answer, the time to the last bit and the points multiplied by it.
#include <cmath>
#include <limits>

#include "catch.hpp"
#include "chance.hpp"
#include "first_contact/batch/batch.hpp"
#include "first_contact/bvh/bvh.hpp"
#include "first_contact/geometry/bounds.hpp"
#include "first_contact/geometry/closest_point.hpp"
#include "first_contact/geometry/line_triangle.hpp"
#include "first_contact/geometry/triangle_distance.hpp"
#include "first_contact/motion/sweep_along.hpp"
#include "first_contact/pairs/first_contacts.hpp"
#include "first_contact/response/slide.hpp"
#include "first_contact/sweep/box_plane.hpp"
#include "first_contact/sweep/ray_triangle.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "first_contact/sweep/sphere_plane.hpp"
#include "first_contact/sweep/sphere_sphere.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"
#include "first_contact/sweep/turning_mesh.hpp"

using namespace first_contact;

namespace {

// The powers of two: the ends of the range, and between them.
constexpr int powers[]{-895, -700, -300, -100, -40, 40, 100, 300, 600, 900, 990};

/// Numbers of few digits, so that they are exact in every unit.
class Scene {
 public:
  explicit Scene(std::uint64_t seed) : chance_(seed) {}

  double number(double low, double high) { return std::round(0x1p16 * chance_.uniform(low, high)) / 0x1p16; }
  Vector vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
  Moving<Sphere> ball() {
    const Point start = vector(4);
    return {{start, number(0, 1)}, vector(1) - 1.5 * start};
  }
  Mesh mesh() {
    std::vector<Point> vertices;
    for (int i = 0; i < 12; ++i) vertices.push_back(vector(2));
    std::vector<Mesh::Face> faces;
    for (int i = 0; i < 8; ++i) {
      const auto a = static_cast<std::uint32_t>(chance_.pick(12));
      faces.push_back({a, (a + 1 + static_cast<std::uint32_t>(chance_.pick(5))) % 12, (a + 7) % 12});
    }
    return {vertices, faces};
  }
  Chance& chance() { return chance_; }

 private:
  Chance chance_;
};

double times(double length, int power) { return std::ldexp(length, power); }
Vector times(const Vector& v, int power) {
  return {times(v.x(), power), times(v.y(), power), times(v.z(), power)};
}
Sphere times(const Sphere& s, int power) { return {times(s.center, power), times(s.radius, power)}; }
Box times(const Box& b, int power) {
  return {times(b.center, power), times(b.r, power), times(b.s, power), times(b.t, power)};
}
Triangle times(const Triangle& t, int power) {
  return {times(t.a, power), times(t.b, power), times(t.c, power)};
}
Mesh times(const Mesh& mesh, int power) {
  std::vector<Point> vertices;
  for (const Point& p : mesh.vertices()) vertices.push_back(times(p, power));
  return {vertices, mesh.faces()};
}
template <class Shape>
Moving<Shape> times(const Moving<Shape>& moving, int power) {
  return {times(moving.shape, power), times(moving.displacement, power)};
}
std::vector<Point> times(const std::vector<Point>& points, int power) {
  std::vector<Point> all;
  for (const Point& p : points) all.push_back(times(p, power));
  return all;
}

// Equal but for the rounding to the smallest doubles, which is all that another unit may do.
void check_scaled(const Vector& answer, const Vector& at_size_1, int power) {
  const Vector expected = times(at_size_1, power);
  for (int k = 0; k < 3; ++k)
    REQUIRE(std::abs(answer[k] - expected[k]) <= 2 * std::numeric_limits<double>::denorm_min());
}

void check_scaled(const std::optional<Contact>& answer, const std::optional<Contact>& at_size_1, int power) {
  REQUIRE(answer.has_value() == at_size_1.has_value());
  if (!answer) return;
  REQUIRE(answer->time == at_size_1->time);
  REQUIRE(answer->normal == at_size_1->normal);
  REQUIRE(answer->feature == at_size_1->feature);
  REQUIRE(answer->triangle == at_size_1->triangle);
  REQUIRE(answer->points.cols() == at_size_1->points.cols());
  for (Eigen::Index k = 0; k < answer->points.cols(); ++k)
    check_scaled(answer->points.col(k), at_size_1->points.col(k), power);
}

void check_scaled(const std::optional<CurveContact>& answer, const std::optional<CurveContact>& at_size_1,
                  int power) {
  REQUIRE(answer.has_value() == at_size_1.has_value());
  if (!answer) return;
  REQUIRE(answer->u == at_size_1->u);
  check_scaled(std::optional(answer->contact), std::optional(at_size_1->contact), power);
}

// Asks `ask(power)` in each unit; it compares by check_scaled what it finds with what it finds at size 1.
template <class Ask>
void in_every_unit(std::uint64_t seed, int rounds, const Ask& ask) {
  Scene scene(seed);
  for (int i = 0; i < rounds; ++i) {
    CAPTURE(seed, i);
    ask(scene);
  }
}

}  // namespace

TEST_CASE("A sphere meets a plane, a sphere and a triangle at the same time in every unit") {
  int hits = 0;
  in_every_unit(1301, 400, [&](Scene& scene) {
    const Moving<Sphere> ball = scene.ball(), other = scene.ball();
    const Vector normal = scene.vector(1) + Vector(0, 0, 2);
    const double offset = scene.number(-1, 1);
    const Triangle triangle{scene.vector(2), scene.vector(2), scene.vector(2)};
    const auto on_plane = sweep(ball, Plane(normal, offset));
    const auto on_sphere = sweep(ball, other);
    const auto on_triangle = sweep(ball, triangle);
    const auto ray = sweep(Moving<Point>{ball.shape.center, ball.displacement}, triangle);
    hits += on_plane.has_value() + on_sphere.has_value() + on_triangle.has_value() + ray.has_value();
    for (const int power : powers) {
      CAPTURE(power);
      const Moving<Sphere> large = times(ball, power);
      check_scaled(sweep(large, Plane(normal, times(offset, power))), on_plane, power);
      check_scaled(sweep(large, times(other, power)), on_sphere, power);
      check_scaled(sweep(large, times(triangle, power)), on_triangle, power);
      check_scaled(sweep(Moving<Point>{large.shape.center, large.displacement}, times(triangle, power)), ray,
                   power);
    }
  });
  CHECK(hits > 400);
}

TEST_CASE("A box meets a plane at the same time in every unit") {
  in_every_unit(1302, 400, [](Scene& scene) {
    const Box box{scene.vector(2), {scene.number(0, 2), 0, 0}, {0, scene.number(0, 2), 0}, {0, 0, 1}};
    const Moving<Box> moving{box, scene.vector(4)};
    const Vector normal = scene.vector(1) + Vector(0, 0, 2);
    const double offset = scene.number(-1, 1);
    const auto contact = sweep(moving, Plane(normal, offset));
    for (const int power : powers) {
      CAPTURE(power);
      check_scaled(sweep(times(moving, power), Plane(normal, times(offset, power))), contact, power);
    }
  });
}

TEST_CASE("A sphere meets an environment, and a fast tree, at the same time in every unit") {
  int hits = 0;
  in_every_unit(1303, 100, [&](Scene& scene) {
    const Mesh mesh = scene.mesh();
    std::vector<Moving<Sphere>> balls;
    for (int k = 0; k < 10; ++k) balls.push_back(scene.ball());
    const Environment environment(mesh);
    for (const int power : powers) {
      CAPTURE(power);
      const Environment large(times(mesh, power));
      const Bvh tree(times(mesh, power));
      for (const auto& ball : balls) {
        const auto contact = sweep(ball, environment);
        hits += contact.has_value();
        check_scaled(sweep(times(ball, power), large), contact, power);
        check_scaled(sweep(times(ball, power), tree), contact, power);
      }
    }
  });
  CHECK(hits > 3000);
}

TEST_CASE("What overlaps does so in every unit, and the nearest points are the same") {
  in_every_unit(1304, 400, [](Scene& scene) {
    const Sphere ball = scene.ball().shape, other = scene.ball().shape;
    const Triangle a{scene.vector(2), scene.vector(2), scene.vector(2)};
    const Triangle b{scene.vector(2), scene.vector(2), scene.vector(2)};
    const Bounds bounds = bounds_between(Point(-1, -0.5, -0.25), Point(0.5, 1, 0.75));
    const NearestPoints pair = nearest_points(a, b);
    const Point near = closest_point(ball.center, a);
    const auto weights = weights_where_line_meets(ball.center, other.center, a);
    for (const int power : powers) {
      CAPTURE(power);
      const Triangle large = times(a, power);
      REQUIRE(overlap(times(ball, power), times(other, power)) == overlap(ball, other));
      REQUIRE(overlap(times(ball, power), large) == overlap(ball, a));
      REQUIRE(overlap(large, bounds_between(times(bounds.min(), power), times(bounds.max(), power))) ==
              overlap(a, bounds));
      check_scaled(closest_point(times(ball.center, power), large), near, power);
      const NearestPoints large_pair = nearest_points(large, times(b, power));
      check_scaled(large_pair.first, pair.first, power);
      check_scaled(large_pair.second, pair.second, power);
      const auto same = weights_where_line_meets(times(ball.center, power), other.center, large);
      REQUIRE(same.has_value() == weights.has_value());
      if (same) REQUIRE(*same == *weights);
    }
  });
}

TEST_CASE("A mesh that turns meets another at the same time in every unit") {
  in_every_unit(1305, 10, [](Scene& scene) {
    const Mesh mover = scene.mesh(), obstacle = scene.mesh();
    const Point hinge(0, 0, 8);
    const auto contact = sweep(Turning<Mesh>{mover, hinge, {1, 2, 3}, 2}, obstacle);
    for (const int power : {-895, -300, 300, 990}) {
      CAPTURE(power);
      check_scaled(sweep(Turning<Mesh>{times(mover, power), times(hinge, power), {1, 2, 3}, 2},
                         times(obstacle, power)),
                   contact, power);
    }
  });
}

TEST_CASE("All pairs meet at the same times in every unit") {
  in_every_unit(1306, 20, [](Scene& scene) {
    std::vector<Moving<Sphere>> balls;
    for (int k = 0; k < 40; ++k) balls.push_back(scene.ball());
    const auto found = first_contacts(balls);
    for (const int power : powers) {
      CAPTURE(power);
      std::vector<Moving<Sphere>> large;
      for (const auto& ball : balls) large.push_back(times(ball, power));
      const auto same = first_contacts(large);
      REQUIRE(same.size() == found.size());
      for (std::size_t k = 0; k < found.size(); ++k) {
        REQUIRE((same[k].first == found[k].first && same[k].second == found[k].second));
        check_scaled(same[k].contact, found[k].contact, power);
      }
    }
  });
}

TEST_CASE("A batch of spheres, and one against a plane, takes the plain sweep's times in every unit") {
  in_every_unit(1308, 10, [](Scene& scene) {
    std::vector<Moving<Sphere>> p, q;
    for (int k = 0; k < 37; ++k) p.push_back(scene.ball()), q.push_back(scene.ball());
    const Plane plane({0.5, -0.25, 1}, 0.125);
    for (const int power : powers) {
      CAPTURE(power);
      std::array<std::vector<double>, 14> columns;
      for (std::size_t k = 0; k < p.size(); ++k) {
        const Moving<Sphere> a = times(p[k], power), b = times(q[k], power);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const auto n = static_cast<Eigen::Index>(axis);
          columns[axis].push_back(a.shape.center[n]), columns[axis + 3].push_back(a.displacement[n]);
          columns[axis + 7].push_back(b.shape.center[n]), columns[axis + 10].push_back(b.displacement[n]);
        }
        columns[6].push_back(a.shape.radius), columns[13].push_back(b.shape.radius);
      }
      const auto three = [&](std::size_t from) {
        return Columns{columns[from], columns[from + 1], columns[from + 2]};
      };
      const MovingSpheres all_p(three(0), columns[6], three(3)), all_q(three(7), columns[13], three(10));
      std::vector<double> found(p.size()), on_plane(p.size());
      sweep(all_p, all_q, found);
      sweep(all_p, Plane({0.5, -0.25, 1}, times(0.125, power)), on_plane);
      for (std::size_t k = 0; k < p.size(); ++k) {
        const auto contact = sweep(p[k], q[k]), down = sweep(p[k], plane);
        REQUIRE(found[k] == (contact ? contact->time : no_contact));
        REQUIRE(on_plane[k] == (down ? down->time : no_contact));
      }
    }
  });
}

TEST_CASE("A slide, and a way along a curve, go the same way in every unit") {
  in_every_unit(1307, 60, [](Scene& scene) {
    const Mesh mesh = scene.mesh();
    const Moving<Sphere> ball = scene.ball();
    const Environment environment(mesh);
    const Slide path = slide(ball, environment);
    const std::vector<Point> points{ball.shape.center, scene.vector(3), scene.vector(3), scene.vector(3)};
    const auto along = sweep_along(Bezier(points), ball.shape.radius, environment, 0.125);
    for (const int power : {-900, -300, 300, 900}) {
      CAPTURE(power);
      const Environment large(times(mesh, power));
      const Slide same = slide(times(ball, power), large);
      REQUIRE(same.ending == path.ending);
      REQUIRE(same.positions.size() == path.positions.size());
      for (std::size_t k = 0; k < path.positions.size(); ++k)
        check_scaled(same.positions[k], path.positions[k], power);
      check_scaled(sweep_along(Bezier(times(points, power)), times(ball.shape.radius, power), large,
                               times(0.125, power)),
                   along, power);
    }
  });
}

TEST_CASE("A ball of 1 from 1e300 away hits what it is aimed at, and passes what is beside its way") {
  const Moving<Sphere> from_afar{{{1e300, 0, 0}, 1}, {-2e300, 0, 0}};
  const auto hit = sweep(from_afar, Sphere{{0, 0, 0}, 1});
  REQUIRE(hit);
  CHECK(hit->time == 0.5);
  CHECK(hit->normal == Vector(1, 0, 0));
  CHECK_FALSE(sweep(from_afar, Sphere{{0, 3, 0}, 1}));
  CHECK(sweep(from_afar, Sphere{{0, 1.999, 0}, 1}));
  CHECK_FALSE(sweep(from_afar, Sphere{{0, 1e200, 0}, 1}));
  const auto on_triangle = sweep(from_afar, Triangle{{0, -1, -1}, {0, 2, -1}, {0, -1, 2}});
  REQUIRE(on_triangle);
  CHECK(on_triangle->time == Approx(0.5));
  CHECK(on_triangle->point().allFinite());
}

TEST_CASE("A floor as wide as 1e200 carries a ball of 1") {
  const Triangle floor{{-1e200, -1e200, 0}, {1e200, -1e200, 0}, {0, 1e200, 0}};
  const auto contact = sweep(Moving<Sphere>{{{0, 0, 3}, 1}, {0, 0, -4}}, floor);
  REQUIRE(contact);
  CHECK(contact->time == Approx(0.5).epsilon(1e-15));
  CHECK(contact->feature == Feature::face);
}

TEST_CASE("What is far away does not touch what is near: a mesh with one vertex at 1e250") {
  const Mesh mesh({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1e250, 1e250, 1e250}, {1e250, 1e250, 2e250}},
                  {{0, 1, 2}, {2, 3, 4}});
  const auto contact = sweep(Moving<Sphere>{{{1, 1, 3}, 1}, {0, 0, -4}}, Environment(mesh));
  REQUIRE(contact);
  CHECK(contact->time == 0.5);
  CHECK(contact->triangle == 0);
}

TEST_CASE("Beyond the range a shape or a motion is refused when it is made, by its value and the rule") {
  const double end = largest_length, beyond = std::nextafter(end, INFINITY);
  CHECK_NOTHROW(Moving<Sphere>{{{end, -end, 0}, end}, {0, end, 0}});
  CHECK_THROWS_WITH((Sphere{{beyond, 0, 0}, 1}),
                    "sphere's centre 1.07151e+301, 0, 0: must be finite, and at most 1.07e301 (2^1000)");
  CHECK_THROWS_AS((Sphere{{0, 0, 0}, beyond}), std::invalid_argument);
  CHECK_THROWS_AS((Moving<Sphere>{{{0, 0, 0}, 1}, {0, 0, -beyond}}), std::invalid_argument);
  CHECK_THROWS_AS((Triangle{{0, 0, 0}, {0, beyond, 0}, {1, 0, 0}}), std::invalid_argument);
  CHECK_THROWS_AS((Mesh{{{0, 0, beyond}}, {}}), std::invalid_argument);
  CHECK_THROWS_AS((Box{{0, 0, 0}, {beyond, 0, 0}, {0, 1, 0}, {0, 0, 1}}), std::invalid_argument);
  CHECK_THROWS_AS((Plane{{0, 0, 1}, 1e308}), std::invalid_argument);
  CHECK_THROWS_AS(bounds_between(Point(-beyond, 0, 0), Point(0, 0, 0)), std::invalid_argument);
}
