#include "first_contact/mesh_io/polygons.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <numeric>

#include "catch.hpp"
#include "chance.hpp"
#include "first_contact/mesh_io/flat_polygon.hpp"
#include "first_contact/mesh_io/orientation.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "mesh_files.hpp"

using namespace first_contact;
using Eigen::Vector2d;
using Exact = boost::multiprecision::cpp_int;

namespace {

// A double as a multiple of 2^-1074.
Exact exact(double value) {
  int exponent = 0;
  const auto digits = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
  return value == 0 ? Exact(0) : Exact(digits) << (exponent - 53 + 1074);
}

// Twice the area of a triangle, counterclockwise positive.
Exact twice_area(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return (exact(b.x()) - exact(a.x())) * (exact(c.y()) - exact(a.y())) -
         (exact(b.y()) - exact(a.y())) * (exact(c.x()) - exact(a.x()));
}

Exact twice_area(const FlatPolygon& polygon) {
  Exact sum = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) sum += twice_area(polygon[0], polygon[i - 1], polygon[i]);
  return sum;
}

// Even-odd: how often does a ray to the right meet the outline?
bool within(const FlatPolygon& polygon, const Vector2d& p) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    inside ^= (twice_area(a, b, p) > 0) == (a.y() < b.y());
  }
  return inside;
}

// That triangles fill a polygon: none turns the wrong way, all together are as large, and their middles lie
// within.
void check_filled(const FlatPolygon& polygon) {
  const auto triangles = clip_ears(polygon);
  REQUIRE(triangles.size() + 2 == polygon.size());
  Exact sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const Exact area = twice_area(polygon[a], polygon[b], polygon[c]);
    CHECK(area >= 0);
    sum += area;
    if (area > 0) CHECK(within(polygon, (polygon[a] + polygon[b] + polygon[c]) / 3));
  }
  CHECK(sum == twice_area(polygon));
}

// A star-shaped outline with many dents: directions in order, distances at random.
FlatPolygon dented(Chance& chance, int corners) {
  FlatPolygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 6.283185307179586 * i / corners, distance = chance.uniform(0.1, 1);
    polygon.emplace_back(distance * std::cos(angle), distance * std::sin(angle));
  }
  return polygon;
}

Cut cut(const std::vector<Point>& corners, std::vector<Mesh::Face>& faces) {
  std::vector<std::uint32_t> polygon(corners.size());
  std::iota(polygon.begin(), polygon.end(), 0U);
  return add_triangles(faces, corners, polygon);
}

double area(const Mesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.faces())
    sum +=
        0.5 * (mesh.vertices()[b] - mesh.vertices()[a]).cross(mesh.vertices()[c] - mesh.vertices()[a]).norm();
  return sum;
}

}  // namespace

TEST_CASE("On which side of a line a point lies is decided without rounding") {
  const Vector2d a(0, 0), b(3, 1);
  const double tiny = 0x1p-60;
  CHECK(orientation(a, b, {6, 2}) == 0);
  CHECK(orientation({tiny, 0}, b, {6, 2}) == -1);
  CHECK(orientation({-tiny, 0}, b, {6, 2}) == 1);
  Chance chance(1);
  for (int i = 0; i < 20000; ++i) {  // points a few last bits from a line
    const auto near = [&](double t) -> Vector2d {
      return Vector2d(0.5 + t * 12, 0.5 + t * 12) +
             0x1p-53 * Vector2d(static_cast<double>(chance.pick(64)), static_cast<double>(chance.pick(64)));
    };
    const Vector2d p = near(0), q = near(chance.uniform(0, 1)), r = near(1);
    const Exact area = twice_area(p, q, r);
    CAPTURE(i);
    CHECK(orientation(p, q, r) == area.sign());
  }
}

TEST_CASE("The ears of a polygon with any dents fill it: exact areas, and nothing outside") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Chance chance(seed);
    CAPTURE(seed);
    check_filled(dented(chance, 4 + static_cast<int>(chance.pick(40))));
  }
}

TEST_CASE("Ears fill a comb, a spiral and a staircase with corners on straight lines") {
  FlatPolygon comb{{0, -1}, {20, -1}};
  for (int i = 20; i-- > 0;) comb.emplace_back(i + 0.5, i % 2 == 0 ? 9 : 0);
  check_filled(comb);
  FlatPolygon stairs{{0, 0}, {4, 0}, {8, 0}};
  for (int i = 8; i-- > 0;) stairs.insert(stairs.end(), {Vector2d(i + 1, 8 - i), Vector2d(i, 8 - i)});
  check_filled(stairs);
  FlatPolygon spiral, inner;
  for (int i = 0; i < 60; ++i) {
    const double angle = 0.3 * i, distance = 1 + 0.2 * i;
    spiral.emplace_back(distance * std::cos(angle), distance * std::sin(angle));
    inner.emplace_back((distance - 0.5) * std::cos(angle), (distance - 0.5) * std::sin(angle));
  }
  spiral.insert(spiral.end(), inner.rbegin(), inner.rend());
  check_filled(spiral);
}

TEST_CASE("A long spiral, in which most corners are no ears, is cut in seconds") {
  FlatPolygon spiral, inner;
  for (int i = 0; i < 3000; ++i) {
    const double angle = 0.05 * i, distance = 10 + 0.01 * i;
    spiral.emplace_back(distance * std::cos(angle), distance * std::sin(angle));
    inner.emplace_back((distance - 0.3) * std::cos(angle), (distance - 0.3) * std::sin(angle));
  }
  spiral.insert(spiral.end(), inner.rbegin(), inner.rend());
  CHECK(clip_ears(spiral).size() == spiral.size() - 2);
}

TEST_CASE("A hole that is joined to the outline by an edge there and back stays empty") {
  const FlatPolygon square{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}};
  CHECK_FALSE(crosses_itself(square));
  check_filled(square);
  CHECK(twice_area(square) == 2 * 12 * (Exact(1) << 2148));
}

TEST_CASE(
    "A convex polygon is cut into a fan from its first corner, and three corners on a line are no fan's") {
  std::vector<Mesh::Face> faces;
  CHECK(cut({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, faces) == Cut::whole);
  CHECK(faces == std::vector<Mesh::Face>{{0, 1, 2}, {0, 2, 3}});
  const Mesh mesh = read("a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3 4\n");
  CHECK(area(mesh) == 2);
  for (std::size_t i = 0; i < mesh.size(); ++i) CHECK_FALSE(mesh.triangle(i).area_vector().isZero());
}

TEST_CASE("A face with a dent is no larger than it is: what falls beside it touches nothing") {
  const Mesh mesh = read("a.obj", "v 0 0 0\nv 2 1 0\nv 4 0 0\nv 2 4 0\nf 1 2 3 4\n");
  CHECK(mesh.size() == 2);
  CHECK(area(mesh) == 6);
  CHECK_FALSE(sweep(Moving<Sphere>{{{2, 0.5, 1}, 0.1}, {0, 0, -2}}, Environment(mesh)));
  CHECK(sweep(Moving<Sphere>{{{2, 2, 1}, 0.1}, {0, 0, -2}}, Environment(mesh)));
}

TEST_CASE("A face is cut alike wherever it stands in space, at any size, and from its back") {
  const std::vector<Vector2d> dart{{0, 0}, {2, 1}, {4, 0}, {2, 4}};
  for (const double size : {1e-300, 1.0, 1e300})
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      for (const bool back : {false, true}) {
        CAPTURE(size, axis, back);
        std::vector<Point> corners;
        for (const Vector2d& p : dart) {
          Point corner = Point::Constant(0.25 * size);
          corner[(axis + 1) % 3] = size * p.x();
          corner[(axis + 2) % 3] = size * p.y();
          corners.push_back(corner);
        }
        if (back) std::reverse(corners.begin(), corners.end());
        std::vector<Mesh::Face> faces;
        CHECK(cut(corners, faces) == Cut::whole);
        REQUIRE(faces.size() == 2);
        const std::uint32_t dent = back ? 2 : 1;
        for (const auto& face : faces) CHECK(std::count(face.begin(), face.end(), dent) == 1);
      }
}

TEST_CASE("A face that crosses itself is told, and read all the same") {
  const Folder folder;
  ReadingNotes notes;
  const auto told = [&](const std::string& bytes) {
    const Mesh mesh = read_mesh(folder.file("a.obj", bytes), {}, &notes);
    return notes.crossing;
  };
  CHECK(told("v 0 0 0\nv 2 2 0\nv 2 0 0\nv 0 3 0\nf 1 2 3 4\n") == 1);
  CHECK(told("v 0 0 0\nv 2 2 0\nv 2 0 0\nv 0 2 0\nf 1 2 3 4\n") ==
        1);  // two halves that turn each its own way
  CHECK(told("v 1 0 0\nv -.81 .59 0\nv .31 -.95 0\nv .31 .95 0\nv -.81 -.59 0\nf 1 2 3 4 5\n") == 1);
  CHECK(told("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.1\nf 1 2 3 4\n") == 0);
  CHECK(told("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 1 2 3\n") == 0);
  CHECK(told("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nf 1 2 3 4\n") == 0);
}

TEST_CASE("A face of too many corners is refused if it is not convex: to cut it would take for ever") {
  std::string bytes;
  for (std::size_t i = 0; i <= most_corners; ++i)
    bytes += "v " + std::to_string(i) + " " + std::to_string(i % 2) + " 0\n";
  bytes += "v 0 -1 0\nf";
  for (std::size_t i = 0; i <= most_corners + 1; ++i) bytes += " " + std::to_string(i + 1);
  CHECK_THAT(refusal("a.obj", bytes + "\n"), ContainsSubstring("face 1: is not convex"));
}
