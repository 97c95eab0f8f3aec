// Somebody else's program, to be compiled with options of their own: its answers are the library's, bit for
// bit, and its shapes are laid out as the library's are.
#include <bit>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <memory>

#include "first_contact/bvh/bvh.hpp"
#include "first_contact/geometry/frustum.hpp"
#include "first_contact/geometry/triangle_distance.hpp"
#include "first_contact/motion/rigid_tween.hpp"
#include "first_contact/motion/sweep_along.hpp"
#include "first_contact/motion/tween.hpp"
#include "first_contact/pairs/first_contacts.hpp"
#include "first_contact/pairs/space_time.hpp"
#include "first_contact/response/impact.hpp"
#include "first_contact/response/slide.hpp"
#include "first_contact/stage/hit_test.hpp"
#include "first_contact/sweep/box_plane.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "first_contact/sweep/sphere_plane.hpp"
#include "first_contact/sweep/sphere_sphere.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"
#include "first_contact/sweep/turning_mesh.hpp"
#include "first_contact/trees/bsp_tree.hpp"
#include "first_contact/trees/objects.hpp"
#include "first_contact/trees/octree.hpp"
#include "first_contact/trees/soup.hpp"

using namespace first_contact;

// Doubles, sizes and pointers alone: so much must a type have, and no compiler option may add to it.
template <class Type>
constexpr bool of_doubles(std::size_t count) {
  return sizeof(Type) == count * sizeof(double) && alignof(Type) == alignof(double);
}
static_assert(of_doubles<Point>(3) && of_doubles<Vector2>(2) && of_doubles<Homogeneous>(4) &&
              of_doubles<Matrix>(16));
static_assert(of_doubles<Plane>(4) && of_doubles<Sphere>(4) && of_doubles<Box>(12) &&
              of_doubles<Triangle>(9));
static_assert(of_doubles<Moving<Sphere>>(7) && of_doubles<Moving<Box>>(15) && of_doubles<Bounds>(6));
static_assert(of_doubles<Transform>(36) && of_doubles<Rigid>(12) && of_doubles<Quaternion>(4) &&
              of_doubles<Frustum>(24));
static_assert(of_doubles<Rectangle>(4) && of_doubles<Body<2>>(3) && of_doubles<Impact<3>>(9));
static_assert(alignof(Contact) == alignof(double) && alignof(Pose) == alignof(double));
static_assert(alignof(SpaceTimeBox) == alignof(double) && alignof(BspNode) == alignof(double));
static_assert(alignof(ContactPoints) == alignof(double));

namespace {

std::uint64_t hash = 0xcbf29ce484222325, state = 1;

void add(double value) { hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3; }
template <class Derived>
void add(const Eigen::DenseBase<Derived>& numbers) {
  for (Eigen::Index j = 0; j < numbers.cols(); ++j)
    for (Eigen::Index i = 0; i < numbers.rows(); ++i) add(numbers(i, j));
}
void add(const std::optional<Contact>& contact) {
  add(contact.has_value());
  if (!contact) return;
  add(contact->time);
  add(contact->points);
  add(contact->point());
  add(contact->normal);
}

// A multiple of 2^-40 from -2 to 2, exactly; sums and products of a few of them by powers of two are exact
// too, so that the questions do not depend on the options.
double number() {
  state = state * 6364136223846793005 + 1442695040888963407;
  return static_cast<double>(static_cast<std::int64_t>(state >> 22)) * 0x1p-40 - 2;
}
Point point() { return Point{number(), number(), number()}; }
Moving<Sphere> ball() {
  const Point start = point();
  return {{start, 0.25}, point() - 2 * start};
}

void shapes() {
  const Plane plane{point(), number()};
  const Triangle a{point(), point(), point()}, b{point(), point(), point()};
  add(plane.signed_distance(point()));
  add(a.area_vector());
  add(nearest_points(a, b).distance());
  const Rigid turn{Quaternion{1, number(), number(), number()}, point()};
  add(turn.point(point()));
  add(turn.after(turn).inverse().translation());
  add(turn.transform().plane(plane).coefficients());
  const Box box(point(), {1, 0, 0}, {0, 0.5, 0}, {0, 0, 0.25});
  add(box.effective_radius(plane.normal()));
  add(sweep(Moving<Box>{turn.box(box), point()}, plane));
}

void sweeps(const Environment& environment, const Bvh& bvh, const Soup<Octree>& soup) {
  const Moving<Sphere> mover = ball();
  const Plane plane{point(), number()};
  add(sweep(mover, plane));
  add(sweep(mover, ball()));
  add(sweep(mover, Triangle{point(), point(), point()}));
  add(sweep(mover, environment));
  add(sweep(mover, bvh));
  add(sweep(mover, soup));
  add(slide(mover, environment).end());
  add(slide(mover, plane).end());
}

void motions() {
  const Curve curve = BSpline({point(), point(), point(), point()}, 3);
  add(sweep_along(curve, 0.25, Plane{point(), number()}, 0x1p-6));
  const Tween tween({{0, point(), ease::in_out_cubic, Path::bezier({point()}, true)}, {1, point()}});
  add(tween.at(0.375));
  const auto flat = [] { return Vector2(point().head<2>()); };
  const Body<2> p(1, flat()), q(3, flat());
  add(impact(p, q, Vector2(1, 2), 0.75).velocity_q);
  const StageObject object(std::vector<Point2>{flat(), flat(), flat()});
  add(hit_test_point(object, flat(), true));
  add(object.bounding_box().high);
}

Mesh ground() {
  std::vector<Point> vertices;
  for (int i = 0; i < 16; ++i) vertices.emplace_back(i % 4 - 1.5, i / 4 - 1.5, number());
  std::vector<Mesh::Face> faces;
  for (std::uint32_t i = 0; i < 11; ++i) faces.push_back({i, i + 1, i + 5});
  return {vertices, faces};
}

}  // namespace

int main() {
  const Environment environment(ground());
  const Bvh bvh(environment.mesh());
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < environment.mesh().size(); ++i)
    triangles.push_back(environment.mesh().triangle(i));
  const Soup<Octree> soup(triangles);
  for (int i = 0; i < 500; ++i) {
    shapes();
    sweeps(environment, bvh, soup);
    motions();
  }
  std::vector<Moving<Sphere>> balls;
  for (int i = 0; i < 200; ++i) balls.push_back(ball());
  for (const PairContact& pair : first_contacts(balls)) add(pair.contact);
  std::printf("%016" PRIx64 "\n", hash);
}
