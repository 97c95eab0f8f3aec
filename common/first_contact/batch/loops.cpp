// The idea: an `if` would send four sweeps four ways; a choice between two results does not. So every sweep
// does all of its arithmetic and picks its answer at the end, and one instruction does it for as many as the
// processor takes at once.
//
// Equal to: sphere_sphere.cpp, sphere_plane.cpp and box_plane.cpp, operation by operation, in the same order;
// in the sums, the order of products.hpp. Each operation is rounded once, as IEEE 754 has it, whatever
// the processor: so the results are equal.
//
// This file is read once for each kind of processor. Left out are those that cannot multiply and add in one
// rounding, but for the one that runs everywhere; those whose vectors have no fixed length, and so fit into
// no struct; and WebAssembly's vectors, which older Highways have without doubles.
#include "first_contact/batch/loops.hpp"

#include <cmath>

#include "first_contact/batch/desk.hpp"
#include "first_contact/geometry/fused.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "first_contact/batch/loops.cpp"
#define HWY_DISABLED_TARGETS \
  (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV | HWY_WASM)
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace first_contact::batch::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// As many doubles as are taken at once, and a single one.
using Many = hn::CappedTag<double, line>;
using Single = hn::CappedTag<double, 1>;

constexpr double never = __builtin_inf();

// a b + c, rounded once.
template <class D, class Number>
Number fused(D d, Number a, Number b, Number c) {
#if HWY_NATIVE_FMA
  (void)d;
  return MulAdd(a, b, c);
#else
  double of_a[line], of_b[line], of_c[line];
  StoreU(a, d, of_a);
  StoreU(b, d, of_b);
  StoreU(c, d, of_c);
  for (std::size_t k = 0; k < Lanes(d); ++k) of_a[k] = first_contact::fused(of_a[k], of_b[k], of_c[k]);
  return LoadU(d, of_a);
#endif
}

template <class Number>
struct Triple {
  Number x, y, z;
};

template <class Number>
Triple<Number> operator+(const Triple<Number>& a, const Triple<Number>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Number>
Triple<Number> operator-(const Triple<Number>& a, const Triple<Number>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Number>
Number dot(const Triple<Number>& a, const Triple<Number>& b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}
template <class Number>
Triple<Number> cross(const Triple<Number>& a, const Triple<Number>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
// Zero if and only if a is; without squares, which may vanish.
template <class Number>
Number length(const Triple<Number>& a) {
  return Abs(a.x) + Abs(a.y) + Abs(a.z);
}

// As in accurate_cross.hpp.
template <class D, class Number>
Number difference_of_products(D lanes, Number a, Number b, Number c, Number d) {
  const Number cd = c * d;
  const Number left_out = fused(lanes, Neg(c), d, cd);
  return fused(lanes, a, b, Neg(cd)) + left_out;
}
template <class D, class Number>
Triple<Number> accurate_cross(D lanes, const Triple<Number>& a, const Triple<Number>& b) {
  return {difference_of_products(lanes, a.y, b.z, a.z, b.y),
          difference_of_products(lanes, a.z, b.x, a.x, b.z),
          difference_of_products(lanes, a.x, b.y, a.y, b.x)};
}

// What the rounding of x - y left out.
template <class Number>
Number rest(Number x, Number y, Number rounded) {
  const Number y_seen = x - rounded;
  return (x - (rounded + y_seen)) + (y_seen - y);
}
template <class Number>
Triple<Number> rest(const Triple<Number>& x, const Triple<Number>& y, const Triple<Number>& rounded) {
  return {rest(x.x, y.x, rounded.x), rest(x.y, y.y, rounded.y), rest(x.z, y.z, rounded.z)};
}

template <class Number>
struct Ball {
  Triple<Number> center;
  Number radius;
  Triple<Number> displacement;
};

// If c a is less than this part of sum^2, then c / sum is less than sum / a, however all four are rounded.
constexpr double surely = 1 - 0x1p-49;

//! [batch_sphere_sphere]
template <class D, class Number>
Number sphere_sphere(D lanes, const Ball<Number>& p, const Ball<Number>& q) {
  const Number zero = Zero(lanes), one = Set(lanes, 1.0), none = Set(lanes, never);
  const Triple<Number> w = p.center - q.center, u = p.displacement - q.displacement;
  const Triple<Number> w_rest = rest(p.center, q.center, w), u_rest = rest(p.displacement, q.displacement, u);
  const Number d = p.radius + q.radius;
  const Triple<Number> moment = accurate_cross(lanes, w, u) + (cross(w_rest, u) + cross(w, u_rest));

  const Number a = dot(u, u), b = dot(w, u), ww = dot(w, w), dd = d * d;
  const Number discriminant = a * dd - dot(moment, moment);
  const Number c = ww - dd, sum = Sqrt(discriminant) - b;
  Number t = c / sum;
  // The other root, sum / a, is the larger one, but for rounding: only then it is worth a second division.
  const auto doubtful = And(Lt(b, zero), Ge(c * a, Set(lanes, surely) * (sum * sum)));
  if (!AllFalse(lanes, doubtful)) t = IfThenElse(Lt(sum / a, t), sum / a, t);

  const auto meeting = And(And(Ge(discriminant, zero), Gt(a, zero)), Le(t, one));
  t = IfThenElse(meeting, t, none);      // not passing, and within this motion
  t = IfThenElse(Le(ww, dd), zero, t);   // overlapping and going deeper: now
  t = IfThenElse(Lt(b, zero), t, none);  // at rest to each other, sliding along, or leaving
  const auto near = Eq(ww, zero);
  if (AllFalse(lanes, near)) return t;
  const Number now = IfThenElse(Gt(length(u), zero), zero, none);
  return IfThenElse(Eq(length(w), zero), now, t);  // concentric
}
//! [batch_sphere_sphere]

// The time, or no number where squares are so large or so small that their products may have left the range of
// double: then the plain sweep is asked, which chooses a unit (batch.cpp).
template <class D, class Number>
Number time_in_range(D lanes, const Ball<Number>& p, const Ball<Number>& q) {
  const Number least = Set(lanes, 0x1p-400), most = Set(lanes, 0x1p400), zero = Zero(lanes);
  const Triple<Number> w = p.center - q.center, u = p.displacement - q.displacement;
  const Number d = p.radius + q.radius, a = dot(u, u), dd = d * d, size = dot(w, w) + dd;
  const auto ordinary = And(And(Gt(a, least), Lt(a, most)), And(Gt(size, least), Lt(size, most)));
  const auto known = Or(And(ordinary, Or(Eq(d, zero), Gt(dd, least))), Eq(length(u), zero));
  return IfThenElse(known, sphere_sphere(lanes, p, q), Set(lanes, __builtin_nan("")));
}

//! [batch_sphere_plane]
template <class D, class Number>
Number sphere_plane(D lanes, const Ball<Number>& ball, const Triple<Number>& normal, Number offset) {
  const Number zero = Zero(lanes), one = Set(lanes, 1.0), none = Set(lanes, never);
  const auto& [x, y, z] = ball.center;
  const Number distance = (normal.x * x + normal.z * z) + (normal.y * y + offset);
  const Number toward = dot(normal, ball.displacement);
  const Number side = IfThenElse(Eq(distance, zero), Neg(CopySign(one, toward)), CopySign(one, distance));
  const Number gap = Abs(distance) - ball.radius, approach = side * toward;
  const Number entry = Neg(gap) / approach;

  Number t = IfThenElse(Lt(zero, entry), entry, zero);  // overlapping and going deeper: now
  t = IfThenElse(Le(t, one), t, none);                  // not within this motion
  return IfThenElse(Lt(approach, zero), t, none);       // sliding along, leaving, or at rest
}
//! [batch_sphere_plane]

template <class D>
Triple<hn::Vec<D>> at(D lanes, const Vectors& v, std::size_t i) {
  return {LoadU(lanes, v.x + i), LoadU(lanes, v.y + i), LoadU(lanes, v.z + i)};
}
template <class D>
Ball<hn::Vec<D>> at(D lanes, const Spheres& s, std::size_t i) {
  return {at(lanes, s.center, i), LoadU(lanes, s.radius + i), at(lanes, s.displacement, i)};
}

template <class D>
Triple<hn::Vec<D>> normal_of(D lanes, const FlatPlane& plane) {
  return {Set(lanes, plane.x), Set(lanes, plane.y), Set(lanes, plane.z)};
}

// What the plane feels of a box.
template <class D>
hn::Vec<D> effective_radius(D lanes, const Boxes& boxes, std::size_t i, const FlatPlane& plane) {
  const auto normal = normal_of(lanes, plane);
  const auto r = Abs(dot(at(lanes, boxes.r, i), normal)), s = Abs(dot(at(lanes, boxes.s, i), normal)),
             t = Abs(dot(at(lanes, boxes.t, i), normal));
  return Set(lanes, 0.5) * ((r + s) + t);
}

// One time after the other, many at once; the last few one by one.
template <class One>
void each(std::size_t count, double* times, const One& one) {
  const Many many;
  const Single single;
  std::size_t i = 0;
  for (; i + Lanes(many) <= count; i += Lanes(many)) StoreU(one(many, i), many, times + i);
  for (; i < count; ++i) StoreU(one(single, i), single, times + i);
}

// The first `whole` of them, a number of whole lines, with p on the desk.
void from_the_desk(const Spheres& p, const Spheres& q, std::size_t whole, double* times) {
  const Many many;
  Desk desk;
  for (std::size_t i = 0; i < whole && i < Desk::ahead; i += line) desk.put(p, i);
  for (std::size_t i = 0; i < whole; i += line) {
    const Spheres next = desk.take(i);
    for (std::size_t k = 0; k < line; k += Lanes(many))
      StoreU(time_in_range(many, at(many, next, k), at(many, q, i + k)), many, times + i + k);
    if (i + Desk::ahead < whole) desk.put(p, i + Desk::ahead);
  }
}

Spheres from(const Spheres& all, std::size_t i) {
  const auto& [center, radius, displacement] = all;
  return {{center.x + i, center.y + i, center.z + i},
          radius + i,
          {displacement.x + i, displacement.y + i, displacement.z + i}};
}

void sphere_sphere_loop(const Spheres& all_p, const Spheres& all_q, std::size_t count, double* times) {
  const std::size_t done = crowded(all_p, all_q, times) ? count / line * line : 0;
  from_the_desk(all_p, all_q, done, times);
  const Spheres p = from(all_p, done), q = from(all_q, done);
  each(count - done, times + done, [&](auto lanes, std::size_t i) HWY_ATTR {
    return time_in_range(lanes, at(lanes, p, i), at(lanes, q, i));
  });
}

void sphere_plane_loop(const Spheres& all_spheres, const FlatPlane& the_plane, std::size_t count,
                       double* times) {
  const Spheres spheres = all_spheres;
  const FlatPlane plane = the_plane;
  each(count, times, [&](auto lanes, std::size_t i) HWY_ATTR {
    return sphere_plane(lanes, at(lanes, spheres, i), normal_of(lanes, plane), Set(lanes, plane.offset));
  });
}

// First the radii of some, then their times: here, too, never are sixteen columns read at once. So many that
// the processor reads each column ahead in long stretches: with 256 a million boxes took 1.35 times the
// memory's own time, and take 1.10.
void box_plane_loop(const Boxes& all_boxes, const FlatPlane& the_plane, std::size_t count, double* times) {
  constexpr std::size_t block = 4096;
  double radii[block];
  const Boxes boxes = all_boxes;
  const FlatPlane plane = the_plane;
  for (std::size_t first = 0; first < count; first += block) {
    const std::size_t some = count - first < block ? count - first : block;
    each(some, radii, [&](auto lanes, std::size_t i) HWY_ATTR {
      return effective_radius(lanes, boxes, first + i, plane);
    });
    each(some, times + first, [&](auto lanes, std::size_t i) HWY_ATTR {
      const Ball<hn::Vec<decltype(lanes)>> ball{at(lanes, boxes.center, first + i), LoadU(lanes, radii + i),
                                                at(lanes, boxes.displacement, first + i)};
      return sphere_plane(lanes, ball, normal_of(lanes, plane), Set(lanes, plane.offset));
    });
  }
}

}  // namespace
}  // namespace first_contact::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace first_contact::batch {

HWY_EXPORT(sphere_sphere_loop);
HWY_EXPORT(sphere_plane_loop);
HWY_EXPORT(box_plane_loop);

void sphere_sphere(const Spheres& p, const Spheres& q, std::size_t count, double* times) {
  HWY_DYNAMIC_DISPATCH(sphere_sphere_loop)(p, q, count, times);
}
void sphere_plane(const Spheres& spheres, const FlatPlane& plane, std::size_t count, double* times) {
  HWY_DYNAMIC_DISPATCH(sphere_plane_loop)(spheres, plane, count, times);
}
void box_plane(const Boxes& boxes, const FlatPlane& plane, std::size_t count, double* times) {
  HWY_DYNAMIC_DISPATCH(box_plane_loop)(boxes, plane, count, times);
}

}  // namespace first_contact::batch
#endif
