#pragma once
#include <array>
#include <limits>
#include <span>

#include "first_contact/geometry/box.hpp"
#include "first_contact/geometry/plane.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/sweep/contact.hpp"

/// \file
/// Many sweeps at once: `sweep(p, q, times)` for all pairs p[i], q[i]. Each shape is spread over columns, all
/// x in one array, all y in the next ("structure of arrays"), so that one instruction takes four shapes.
///
/// The plain versions are sweep(Moving<Sphere>, Moving<Sphere>), sweep(Moving<Sphere>, Plane) and
/// sweep(Moving<Box>, Plane). The times are theirs, bit for bit: the same formulas in the same order. The
/// rest of a contact is found by the plain version, for those few that have one:
/// `if (times[i] <= 1) sweep(p[i], q[i])`.
///
/// A batch waits for the memory more than for the arithmetic.
/// \see tests/peers/pairs_bench.cpp

namespace first_contact {

/// All x, all y and all z of a set of vectors.
using Columns = std::array<std::span<const double>, 3>;

/// The time of a contact that does not happen: later than all others.
inline constexpr double no_contact = std::numeric_limits<double>::infinity();

/// A view of many moving spheres, in columns of the caller's. The numbers may be changed afterwards, and
/// swept again; who makes one of them NaN or infinite gets no contact for it.
class MovingSpheres {
 public:
  /// \param center        S at t = 0
  /// \param radius        r
  /// \param displacement  V, from t = 0 to t = 1
  /// \throws std::invalid_argument if the columns are not of one length, or a sphere is refused by Sphere or
  ///         Moving.
  MovingSpheres(const Columns& center, std::span<const double> radius, const Columns& displacement);

  /// How many.
  std::size_t size() const { return radius_.size(); }
  /// One of them.
  /// \throws std::invalid_argument as the constructor
  Moving<Sphere> operator[](std::size_t i) const;

  /// S at t = 0.
  const Columns& center() const { return center_; }
  /// r.
  std::span<const double> radius() const { return radius_; }
  /// V.
  const Columns& displacement() const { return displacement_; }

 private:
  Columns center_;
  std::span<const double> radius_;
  Columns displacement_;
};

/// A view of many moving boxes, in columns of the caller's, as MovingSpheres is one of spheres.
class MovingBoxes {
 public:
  /// \param center        Q at t = 0
  /// \param axes          R, S and T, as long as the box is
  /// \param displacement  V, from t = 0 to t = 1
  /// \throws std::invalid_argument if the columns are not of one length, or a box is refused by Box or
  ///         Moving.
  MovingBoxes(const Columns& center, const std::array<Columns, 3>& axes, const Columns& displacement);

  /// How many.
  std::size_t size() const { return center_[0].size(); }
  /// One of them.
  /// \throws std::invalid_argument as the constructor
  Moving<Box> operator[](std::size_t i) const;

  /// Q at t = 0.
  const Columns& center() const { return center_; }
  /// R, S and T.
  const std::array<Columns, 3>& axes() const { return axes_; }
  /// V.
  const Columns& displacement() const { return displacement_; }

 private:
  Columns center_;
  std::array<Columns, 3> axes_;
  Columns displacement_;
};

/// When p[i] first touches q[i], for each i (paper, 2.3); `no_contact` if not within [0, 1].
///
/// Error of t: as that of the plain sweep; in an ordinary scene, unless the spheres graze, below 4e-15.
/// \see tests/oracle/batch.cpp
///
/// \param times  as many as there are pairs, none of them a number of p or q
/// \throws std::invalid_argument if p, q and times are not equally many.
void sweep(const MovingSpheres& p, const MovingSpheres& q, std::span<double> times);

/// When each sphere first touches the plane (paper, 1.2); `no_contact` if not within [0, 1].
/// \throws std::invalid_argument if there are not as many times as spheres.
void sweep(const MovingSpheres& spheres, const Plane& plane, std::span<double> times);

/// When each box first touches the plane (paper, 1.3); `no_contact` if not within [0, 1].
/// \throws std::invalid_argument if there are not as many times as boxes.
void sweep(const MovingBoxes& boxes, const Plane& plane, std::span<double> times);

}  // namespace first_contact
