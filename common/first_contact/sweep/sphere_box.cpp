#include "first_contact/sweep/sphere_box.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "first_contact/geometry/box_frame.hpp"
#include "first_contact/geometry/closest_point.hpp"
#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/unit_scale.hpp"
#include "first_contact/sweep/moved_out.hpp"
#include "first_contact/sweep/nearest.hpp"

namespace first_contact {

namespace {

/// The surface of a box as a sweep asks it, with the box's centre for the origin.
class BoxSurface {
 public:
  explicit BoxSurface(const Box& box);
  std::optional<Touch> first_touch(const Moving<Sphere>& moving) const;
  Point nearest(const Point& point) const;

 private:
  std::optional<Touch> on_diagonal(const Moving<Sphere>& moving, unsigned face) const;
  std::optional<Touch> on_edge(const Moving<Sphere>& moving, unsigned axis, unsigned from) const;
  std::optional<Touch> on_vertex(const Moving<Sphere>& moving, unsigned number) const;
  Vector inward(unsigned vertex, unsigned axis) const {
    return vertices_[vertex ^ 1U << axis] - vertices_[vertex];
  }
  const Facet& facet(unsigned vertex, unsigned axis) const {  // of the face at that end of the axis
    return facets_[2 * (2 * axis + (vertex >> axis & 1U))];
  }

  std::array<Point, 8> vertices_;
  std::vector<Facet> facets_;  // two to a face; the faces by axis, the low end first
};

BoxSurface::BoxSurface(const Box& box) : vertices_(Box(Point::Zero(), box.r, box.s, box.t).vertices()) {
  facets_.reserve(12);
  for (unsigned axis = 0; axis < 3; ++axis)
    for (const unsigned base : {0U, 1U << axis}) {
      const unsigned u = 1U << (axis + 1) % 3, v = 1U << (axis + 2) % 3;
      const Point &a = vertices_[base], &c = vertices_[base + u + v];
      facets_.emplace_back(Triangle(a, vertices_[base + u], c));
      facets_.emplace_back(Triangle(a, c, vertices_[base + v]));
    }
}

/// The seam of a face's two triangles: no edge, but what neither of them answers for.
std::optional<Touch> BoxSurface::on_diagonal(const Moving<Sphere>& moving, unsigned face) const {
  const Facet &one = facets_[2 * face], &other = facets_[2 * face + 1];
  const Point &a = one.triangle.a, &c = one.triangle.c;
  const auto touch = touch_edge(moving, a, c);
  if (!touch) return std::nullopt;
  const std::array<FaceAround, 2> faces{
      {{&one, one.normal.cross(a - c)}, {&other, other.normal.cross(c - a)}}};
  const auto judged = among_faces(*touch, faces, moving);
  return judged && judged->feature == Feature::face ? judged : std::nullopt;
}

std::optional<Touch> BoxSurface::on_edge(const Moving<Sphere>& moving, unsigned axis, unsigned from) const {
  const Point &a = vertices_[from], &b = vertices_[from + (1U << axis)];
  if (a == b) return std::nullopt;
  const auto touch = touch_edge(moving, a, b);
  if (!touch) return std::nullopt;
  const unsigned u = (axis + 1) % 3, v = (axis + 2) % 3;
  const std::array<FaceAround, 2> faces{
      {{&facet(from, u), inward(from, v)}, {&facet(from, v), inward(from, u)}}};
  return among_faces(*touch, faces, moving);
}

std::optional<Touch> BoxSurface::on_vertex(const Moving<Sphere>& moving, unsigned number) const {
  const auto touch = touch_vertex(moving, vertices_[number]);
  if (!touch) return std::nullopt;
  std::vector<Vector> edges;
  std::vector<FaceAround> faces;
  for (unsigned axis = 0; axis < 3; ++axis) {
    if (!inward(number, axis).isZero(0)) edges.push_back(inward(number, axis));
    faces.push_back({&facet(number, axis), Vector::Zero()});
  }
  return among_edges(*touch, edges, faces, moving);
}

/// The earliest over 6 faces, 12 edges and 8 vertices: a box has no valley in which one could hide.
std::optional<Touch> BoxSurface::first_touch(const Moving<Sphere>& moving) const {
  std::optional<Touch> first;
  const auto offer = [&](const std::optional<Touch>& touch) {
    if (touch && (!first || earlier(*touch, *first))) first = touch;
  };
  for (const Facet& facet : facets_) offer(touch_face(moving, facet));
  for (unsigned face = 0; face < 6; ++face) offer(on_diagonal(moving, face));
  for (unsigned axis = 0; axis < 3; ++axis)
    for (unsigned from = 0; from < 8; ++from)
      if (!(from >> axis & 1U)) offer(on_edge(moving, axis, from));
  for (unsigned vertex = 0; vertex < 8; ++vertex) offer(on_vertex(moving, vertex));
  return first;
}

Point BoxSurface::nearest(const Point& point) const {
  Point best = vertices_[0];
  for (const Facet& facet : facets_) {
    const Point candidate = closest_point(point, facet.triangle);
    if (squared_norm(candidate - point) < squared_norm(best - point)) best = candidate;
  }
  return best;
}

/// The sphere's centre lies in the box: is it on its way in?
std::optional<Contact> from_within(const Moving<Sphere>& moving, const BoxFrame& frame) {
  const auto& [center, radius] = moving.shape;
  const Vector depths = frame.half - frame.heights(center).cwiseAbs();
  const double least = depths.minCoeff();
  Vector against = Vector::Zero();  // the motion, as far as it leaves the middle between two faces
  Vector out = Vector::Zero();      // from the nearest face
  double steepest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (depths[static_cast<Eigen::Index>(i)] > least) continue;
    const double height = dot(frame.normals[i], center), toward = dot(frame.normals[i], moving.displacement);
    if (height == 0) {
      against -= toward * frame.normals[i];
      continue;
    }
    const Vector normal = std::copysign(1.0, height) * frame.normals[i];
    const double approach = dot(normal, moving.displacement);
    if (!(approach < 0)) return std::nullopt;  // on its way out
    if (approach < steepest) out = normal;
    steepest = std::min(steepest, approach);
  }
  const Vector normal = out.isZero(0) ? against : out;
  if (normal.isZero(0)) return std::nullopt;
  return Contact{0, only(center + least * normalized(normal)), normalized(normal), Feature::face};
}

/// The sphere overlaps the box, its centre outside.
std::optional<Contact> from_outside(const Moving<Sphere>& moving, const BoxFrame& frame, const Point& foot) {
  const Vector heights = frame.heights(moving.shape.center), beyond = heights.cwiseAbs() - frame.half;
  int farthest = 0;
  beyond.maxCoeff(&farthest);
  const auto sides = (beyond.array() > 0).count();
  const bool over_face = sides == 1 || moving.shape.center == foot;
  const Vector normal =
      over_face
          ? Vector(std::copysign(1.0, heights[farthest]) * frame.normals[static_cast<std::size_t>(farthest)])
          : Vector(normalized(moving.shape.center - foot));
  if (!(dot(normal, moving.displacement) < 0)) return std::nullopt;
  return Contact{0, only(foot), normal,
                 over_face    ? Feature::face
                 : sides == 2 ? Feature::edge
                              : Feature::vertex};
}

/// The question with the box's centre for the origin and, where squares would leave the range of double, in a
/// unit of its own.
struct Seen {
  Seen(const Sphere& sphere, const Vector& displacement, const Box& solid)
      : unit(unit_of(sphere, displacement, solid)),
        moving(Sphere{unit * (sphere.center - solid.center), unit * sphere.radius}, unit * displacement),
        box(Point::Zero(), unit * solid.r, unit * solid.s, unit * solid.t) {}

  static double unit_of(const Sphere& sphere, const Vector& displacement, const Box& box) {
    const double size = std::max({largest(sphere.center - box.center), largest(box.r, box.s, box.t),
                                  largest(displacement), sphere.radius});
    return is_ordinary(size) ? 1 : unit_scale(size);
  }

  double unit;
  Moving<Sphere> moving;
  Box box;
};

}  // namespace

bool overlap(const Sphere& sphere, const Box& box) {
  const Seen seen(sphere, Vector::Zero(), box);
  const Point& center = seen.moving.shape.center;
  return BoxFrame(seen.box).holds(center) ||
         within(BoxSurface(seen.box).nearest(center) - center, seen.moving.shape.radius);
}

std::optional<Contact> sweep(const Moving<Sphere>& moving, const Box& box) {
  const Seen seen(moving.shape, moving.displacement, box);
  const auto& [center, radius] = seen.moving.shape;
  const BoxFrame frame(seen.box);
  const BoxSurface surface(seen.box);
  const Point foot = surface.nearest(center);
  std::optional<Contact> contact;
  if (frame.holds(center))
    contact = from_within(seen.moving, frame);
  else if (within(center - foot, radius))
    contact = from_outside(seen.moving, frame, foot);
  else if (const auto touch = surface.first_touch(seen.moving))
    contact = Contact{touch->time, only(touch->point), touch->normal, touch->feature};
  if (contact) contact->points = (contact->points / seen.unit).colwise() + box.center;
  return contact;
}

std::optional<Contact> sweep(const Moving<Box>& moving, const Sphere& sphere) {
  auto contact = sweep(Moving<Sphere>{sphere, -moving.displacement}, moving.shape);
  if (!contact) return std::nullopt;
  contact->points.colwise() += contact->time * moving.displacement;
  contact->normal = -contact->normal;
  return contact;
}

}  // namespace first_contact
