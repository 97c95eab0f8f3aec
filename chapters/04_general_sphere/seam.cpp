#include "seam.hpp"

#include <random>

#include "first_contact/program/random.hpp"
#include "first_contact/sweep/moved_out.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"

using namespace first_contact;
using program::uniform, program::unit_vector;

namespace general_sphere_chapter {

namespace {

// Two triangles of one plane, and a ball that comes down on their common edge.
struct Shot {
  Triangle left, right;
  Moving<Sphere> ball;
};

Shot shot_at_a_seam(double radius, std::mt19937& random) {
  const Vector normal = unit_vector(random), edge = normal.unitOrthogonal();
  const Point a = unit_vector(random), b = a + edge;
  const Point c = a + 0.5 * edge + (1 + 0.5 * uniform(random)) * normal.cross(edge);
  const Point target = a + (0.5 + 0.4 * uniform(random)) * edge;
  Vector down = unit_vector(random);
  while (down.dot(normal) > -0.3) down = unit_vector(random);
  return {{a, b, c}, {b, a, a + b - c}, {{target + radius * normal - 2 * down, radius}, 3 * down}};
}

bool meets_face(const Moving<Sphere>& ball, const Triangle& triangle) {
  return touch_face(ball, Facet(triangle)).has_value();
}

}  // namespace

//! [seam]
SeamShots shots_at_a_seam(double radius) {
  std::mt19937 random(3);
  SeamShots count{100000, 0, 0};
  for (int i = 0; i < count.balls; ++i) {
    const auto [left, right, ball] = shot_at_a_seam(radius, random);
    count.both_faces_missed += !meets_face(ball, left) && !meets_face(ball, right);
    count.missed += !sweep(ball, left) && !sweep(ball, right);
  }
  return count;
}
//! [seam]

}  // namespace general_sphere_chapter
