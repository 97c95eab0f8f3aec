#include "first_contact/sweep/turning_plane.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/unit_scale.hpp"
#include "first_contact/sweep/course.hpp"

namespace first_contact {

namespace {

// A vertex that nears the plane by less than this part of the scene until t = 1 goes along it, but for rounding.
constexpr double along_rounding = 16 * std::numeric_limits<double>::epsilon();

double scale_of(const Turning<Mesh>& turning, const Plane& plane) {
  double largest = std::max(norm(turning.displacement), std::abs(plane.signed_distance(turning.center)));
  for (const Point& p : turning.shape.vertices()) largest = std::max(largest, norm(p - turning.center));
  return largest;
}

/// The plane as the body meets it: with its normal toward the body, and a point on it.
struct FacingPlane {
  Vector normal;
  Point base;
  double rounding;
  Closeness close;
};

// How long a vertex may go on; nothing if it touches.
std::optional<double> time_of_vertex(const FacingPlane& facing, const Course& course) {
  const bool near = course.height <= facing.close.gap;
  if (near && (facing.close.also_leaving || course.rate < -facing.rounding)) return std::nullopt;
  const double level = near ? std::min(course.height, 0.0) - facing.close.gap / 2 : facing.close.gap / 2;
  return time_above(level, course);
}

Contact contact_of(const Mesh& body, const FacingPlane& facing, double time) {
  std::vector<Point> touching;
  for (const Point& p : body.vertices())
    if (const double height = dot(facing.normal, p - facing.base); height <= facing.close.gap)
      touching.emplace_back(p - height * facing.normal);
  const Feature feature = touching.size() == 1   ? Feature::vertex
                          : touching.size() == 2 ? Feature::edge
                                                 : Feature::face;
  if (touching.size() > 4) touching = {mean(touching)};
  ContactPoints points(3, static_cast<Eigen::Index>(touching.size()));
  for (std::size_t i = 0; i < touching.size(); ++i) points.col(static_cast<Eigen::Index>(i)) = touching[i];
  return {time, points, facing.normal, feature};
}

}  // namespace

std::optional<Contact> sweep(const Turning<Mesh>& turning, const Plane& plane, const Closeness& close) {
  if (turning.shape.vertices().empty() || (turning.angle == 0 && turning.displacement.isZero(0)))
    return std::nullopt;
  const double side = plane.signed_distance(mean(turning.shape.vertices())) < 0 ? -1 : 1;
  const FacingPlane facing{side * plane.normal(),
                           turning.center - plane.signed_distance(turning.center) * plane.normal(),
                           along_rounding * scale_of(turning, plane), close};
  for (double time = 0;;) {
    const Mesh body = turned(turning, time);
    const Going going(turning, time);
    double free = 1 - time;
    for (const Point& p : body.vertices()) {
      const auto until = time_of_vertex(facing, going.of(p, facing.normal, facing.base));
      if (!until) return contact_of(body, facing, time);
      free = std::min(free, *until);
    }
    if (time >= 1) return std::nullopt;
    time = std::min(1.0, time + free);
  }
}

std::optional<Contact> sweep(const Turning<Mesh>& turning, const Plane& plane) {
  return sweep(turning, plane, {turning_gap * scale_of(turning, plane)});
}

}  // namespace first_contact
