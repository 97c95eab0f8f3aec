#include "first_contact/geometry/bounding.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/refuse.hpp"
#include "first_contact/geometry/unit_scale.hpp"

namespace first_contact {

namespace {

// A point counts as outside a sphere when it is farther by this part of the radius: well above the rounding
// in the sphere through four points, so that points of one and the same sphere do not push each other off the
// rim.
constexpr double outside_tolerance = 1e-10;

// An edge is in the span of others when this part of its length, or less, is across them: well above the
// rounding in what is across. (A point that is so little out of the plane of others makes their sphere larger
// by the square of it.)
constexpr double flat_tolerance = 1e-12;

/// Points as seen from the first of them, in a unit in which they are not far from it: a scene that is small
/// and far away loses nothing, and no square leaves the range of double.
struct Nearby {
  explicit Nearby(std::span<const Point> points) : origin(points.front()) {
    double largest = 0;
    for (const Point& p : points) largest = std::max(largest, (p - origin).cwiseAbs().maxCoeff());
    scale = unit_scale(largest);
    for (const Point& p : points) local.push_back(scale * (p - origin));
  }

  Point back(const Point& p) const { return origin + p / scale; }
  double distance(const Point& p, const Point& q) const { return norm(scale * (p - q)) / scale; }

  Point origin;
  double scale;
  std::vector<Point> local;
};

void require_points(std::span<const Point> points) {
  if (points.empty()) refuse("bounding shape of no points", "there must be at least one");
  for (const Point& p : points)
    if (!in_range(p)) require_finite(p, "bounding shape's point");
}

// The smallest box around the points with its sides along the columns of `axes`, which is a rotation.
Box box_along(const Eigen::Matrix3d& axes, std::span<const Point> points) {
  Vector low = product(axes.transpose(), points.front());
  Vector high = low;
  for (const Point& p : points) {
    const Vector along = product(axes.transpose(), p);
    low = low.cwiseMin(along);
    high = high.cwiseMax(along);
  }
  const Vector size = high - low;
  return {product(axes, low + 0.5 * size), size.x() * axes.col(0), size.y() * axes.col(1),
          size.z() * axes.col(2)};
}

//! [through]
// The smallest sphere that has all of one to four points on its rim. Its centre C lies in the plane, line
// or space of the edges d from the first point, and 2 d.(C - P0) = d.d for each: edge by edge the centre is
// moved across those that came before, which changes nothing that they asked. An edge in their span asks
// nothing new.
Sphere through(const std::vector<Point>& rim) {
  if (rim.empty()) return {Point::Zero(), 0};
  std::array<Vector, 3> across;
  std::size_t found = 0;
  Vector to_center = Vector::Zero();
  for (std::size_t i = 1; i < rim.size(); ++i) {
    const Vector edge = rim[i] - rim[0];
    Vector rest = edge;
    for (std::size_t j = 0; j < found; ++j) rest -= dot(across[j], edge) * across[j];
    if (norm(rest) <= flat_tolerance * norm(edge)) continue;
    across[found] = normalized(rest);
    to_center += (0.5 * squared_norm(edge) - dot(edge, to_center)) / dot(edge, across[found]) * across[found];
    ++found;
  }
  return {rim[0] + to_center, norm(to_center)};
}
//! [through]

//! [welzl]
// The smallest sphere around the points that has `rim` on its rim.
Sphere smallest(std::span<const Point> points, const std::vector<Point>& rim) {
  Sphere sphere = rim.empty() ? Sphere{points.front(), 0} : through(rim);
  if (rim.size() == 4) return sphere;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (norm(points[i] - sphere.center) <= (1 + outside_tolerance) * sphere.radius) continue;
    std::vector<Point> wider = rim;
    wider.push_back(points[i]);
    sphere = smallest(points.first(i), wider);
  }
  return sphere;
}
//! [welzl]

// In an order that no one chose: so the expected time is proportional to the number of points, whatever it
// was before.
std::vector<Point> shuffled(std::span<const Point> points) {
  std::vector<Point> order(points.begin(), points.end());
  std::minstd_rand dice(1);  // the same order each time, on every machine
  for (std::size_t i = order.size() - 1; i > 0; --i) std::swap(order[i], order[dice() % (i + 1)]);
  return order;
}

}  // namespace

Box bounding_box(std::span<const Point> points) {
  require_points(points);
  return box_along(Eigen::Matrix3d::Identity(), points);
}

//! [principal_box]
Box principal_box(std::span<const Point> points) {
  require_points(points);
  Point mean = Point::Zero();
  for (const Point& p : points) mean += p / static_cast<double>(points.size());
  double widest = 0;
  for (const Point& p : points) widest = std::max(widest, (p - mean).cwiseAbs().maxCoeff());
  const double unit = unit_scale(widest);  // the axes are those in any unit
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Point& p : points) scatter += (unit * (p - mean)) * (unit * (p - mean)).transpose();
  return box_along(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors(), points);
}
//! [principal_box]

Sphere bounding_sphere(std::span<const Point> points) {
  require_points(points);
  const Nearby nearby(points);
  const Sphere local = smallest(shuffled(nearby.local), {});
  const Point center = nearby.back(local.center);
  double radius = 0;
  for (const Point& p : points) radius = std::max(radius, nearby.distance(p, center));
  return {center, radius};
}

double volume(const Box& box) { return norm(box.r) * norm(box.s) * norm(box.t); }

double volume(const Sphere& sphere) {
  return 4 * std::numbers::pi / 3 * (sphere.radius * sphere.radius * sphere.radius);
}

}  // namespace first_contact
