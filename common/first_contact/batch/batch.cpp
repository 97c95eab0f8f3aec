#include "first_contact/batch/batch.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "first_contact/batch/loops.hpp"
#include "first_contact/geometry/refuse.hpp"
#include "first_contact/sweep/sphere_sphere.hpp"

namespace first_contact {

namespace {

void require_equal(std::size_t length, std::size_t count, const char* what) {
  if (length != count)
    refuse(what + (" of length " + std::to_string(length)),
           "must be of length " + std::to_string(count) + ", as the others");
}

void require_equal(const Columns& columns, std::size_t count, const char* what) {
  for (const auto& column : columns) require_equal(column.size(), count, what);
}

Vector at(const Columns& columns, std::size_t i) { return {columns[0][i], columns[1][i], columns[2][i]}; }

batch::Vectors flat(const Columns& columns) {
  return {columns[0].data(), columns[1].data(), columns[2].data()};
}
batch::Spheres flat(const MovingSpheres& all) {
  return {flat(all.center()), all.radius().data(), flat(all.displacement())};
}
batch::Boxes flat(const MovingBoxes& all) {
  const auto& [r, s, t] = all.axes();
  return {flat(all.center()), flat(r), flat(s), flat(t), flat(all.displacement())};
}
batch::FlatPlane flat(const Plane& plane) {
  const Vector n = plane.normal();
  return {n.x(), n.y(), n.z(), plane.offset()};
}

batch::Vectors from(const batch::Vectors& v, std::size_t first) {
  return {v.x + first, v.y + first, v.z + first};
}
batch::Spheres from(const batch::Spheres& all, std::size_t first) {
  return {from(all.center, first), all.radius + first, from(all.displacement, first)};
}

// By the plain sweep; what is no sphere, or does not move by a number, has no contact.
double one_time(const MovingSpheres& p, const MovingSpheres& q, std::size_t i) {
  const auto is_sphere = [i](const MovingSpheres& all) {
    const double r = all.radius()[i];
    return in_range(at(all.center(), i)) && in_range(at(all.displacement(), i)) && r >= 0 &&
           r <= largest_length;
  };
  if (!is_sphere(p) || !is_sphere(q)) return no_contact;
  const auto contact = sweep(p[i], q[i]);
  return contact ? contact->time : no_contact;
}

}  // namespace

MovingSpheres::MovingSpheres(const Columns& center, std::span<const double> radius,
                             const Columns& displacement)
    : center_(center), radius_(radius), displacement_(displacement) {
  require_equal(center_, size(), "column of the spheres' centres");
  require_equal(displacement_, size(), "column of the spheres' displacements");
  for (std::size_t i = 0; i < size(); ++i)
    (*this)[i];  // makes each of them, and so refuses what must be refused
}

Moving<Sphere> MovingSpheres::operator[](std::size_t i) const {
  return {{at(center_, i), radius_[i]}, at(displacement_, i)};
}

MovingBoxes::MovingBoxes(const Columns& center, const std::array<Columns, 3>& axes,
                         const Columns& displacement)
    : center_(center), axes_(axes), displacement_(displacement) {
  require_equal(center_, size(), "column of the boxes' centres");
  for (const Columns& axis : axes_) require_equal(axis, size(), "column of the boxes' axes");
  require_equal(displacement_, size(), "column of the boxes' displacements");
  for (std::size_t i = 0; i < size(); ++i) (*this)[i];
}

Moving<Box> MovingBoxes::operator[](std::size_t i) const {
  const auto& [r, s, t] = axes_;
  return {{at(center_, i), at(r, i), at(s, i), at(t, i)}, at(displacement_, i)};
}

//! [sweep_batch]
void sweep(const MovingSpheres& p, const MovingSpheres& q, std::span<double> times) {
  require_equal(q.size(), p.size(), "batch of spheres q");
  require_equal(times.size(), p.size(), "span of times");
  constexpr std::size_t block = 1 << 14;  // their times are at hand when the loop is done
  for (std::size_t first = 0; first < times.size(); first += block) {
    const std::size_t count = std::min(block, times.size() - first);
    batch::sphere_sphere(from(flat(p), first), from(flat(q), first), count, times.data() + first);
    for (std::size_t i = first; i < first + count; ++i)
      if (std::isnan(times[i])) times[i] = one_time(p, q, i);
  }
}

void sweep(const MovingSpheres& spheres, const Plane& plane, std::span<double> times) {
  require_equal(times.size(), spheres.size(), "span of times");
  batch::sphere_plane(flat(spheres), flat(plane), times.size(), times.data());
}

void sweep(const MovingBoxes& boxes, const Plane& plane, std::span<double> times) {
  require_equal(times.size(), boxes.size(), "span of times");
  batch::box_plane(flat(boxes), flat(plane), times.size(), times.data());
}
//! [sweep_batch]

}  // namespace first_contact
