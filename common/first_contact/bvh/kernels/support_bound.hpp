// Read once for each kind of processor.
#if defined(FIRST_CONTACT_BVH_KERNELS_SUPPORT_BOUND) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRST_CONTACT_BVH_KERNELS_SUPPORT_BOUND
#undef FIRST_CONTACT_BVH_KERNELS_SUPPORT_BOUND
#else
#define FIRST_CONTACT_BVH_KERNELS_SUPPORT_BOUND
#endif

#include "first_contact/bvh/kernels/path.hpp"
#include "first_contact/bvh/kernels/vertices.hpp"

/// \file
/// A time before which the sphere cannot touch a triangle, for eight triangles at once.
///
/// The idea, the support bound. Take any direction q, of any length, from the centre p towards the triangle.
/// All points x of the triangle have q.(x - p) >= s, where s is the least of the three corners'. While s > r
/// |q|, a plane at right angles to q keeps the sphere and the triangle apart, and the gap closes with the
/// speed q.v: if q.v <= 0, never; or else not before (s - r |q|) / (q.v). That holds for *every* q. So q may
/// come from a quick and rough calculation, of the point nearest to the centre, and the bound is still right;
/// only s, |q| and q.v must be computed with care, and their rounding added to r. From the new position the
/// step can be taken once more: it is Newton's method on a convex function, from below.
///
/// It equals the distance test of sphere_triangle.cpp, with "certainly not" in place of "no".
///
/// The rounding. In the leaf's unit, coordinates of corners are at most 1 and are rounded once, by 2^-24 each.
/// Everything else is relative to the centre at the time of entry, so that its roundings, fewer than 16 in
/// each product with q, are of 2^-24 |q| M, where M^2 = |a - p|^2 + the longer of two squared sides. The bound
/// uses 2^-18 M: four times as much.

HWY_BEFORE_NAMESPACE();
namespace first_contact::bvh::HWY_NAMESPACE {

/// Eight triangles, and what of them does not depend on where the sphere is: sides u = ab, v = ac, their
/// products.
struct Triangles {
  Triple<Floats> a, u, v, normal;
  Floats uu, uv, vv, ww;        // w = bc
  Floats by_uu, by_vv, by_ww;   // about 1 / them
  Floats determinant, longest;  // uu vv - uv^2 (0 if degenerate), max(uu, vv)
};

HWY_INLINE Triangles triangles(const LeafHead& head, const float* centre) {
  const Corners corner = corners(head, centre);
  const Floats tiny = all(0x1p-100F);
  Triangles t;
  t.a = corner.a;
  t.u = corner.b - corner.a;
  t.v = corner.c - corner.a;
  t.normal = cross(t.u, t.v);
  t.uu = dot(t.u, t.u);
  t.uv = dot(t.u, t.v);
  t.vv = dot(t.v, t.v);
  t.ww = most(t.uu + t.vv - (t.uv + t.uv), tiny);
  t.by_uu = about_one_over(most(t.uu, tiny));
  t.by_vv = about_one_over(most(t.vv, tiny));
  t.by_ww = about_one_over(t.ww);
  t.determinant = minus_product(t.uu * t.vv, t.uv, t.uv);
  t.longest = most(t.uu, t.vv);
  return t;
}

/// On which sides of a triangle does a point lie? Of v and w, the weights of b and c times the determinant,
/// and of what they leave of it for a, the least.
HWY_INLINE Floats least_weight(const Triangles& t, const Floats& ua, const Floats& va) {
  const Floats v = minus_product(t.uv * va, t.vv, ua), w = minus_product(t.uv * ua, t.uu, va);
  return least(least(v, w), t.determinant - (v + w));
}

/// About the direction from p to the nearest point of each triangle, where `to_a` = a - p. On a side it is
/// the nearest of the three clamped feet; over the face the normal. `beside`: on a side
HWY_INLINE Triple<Floats> about_nearest(const Triangles& t, const Triple<Floats>& to_a, FloatMask& beside) {
  const Floats zero = all(0), one = all(1);
  const auto clamp = [&](const Floats& x) HWY_ATTR { return least(most(x, zero), one); };
  const Floats ua = dot(t.u, to_a), va = dot(t.v, to_a), wa = (va - ua) + (t.uv - t.uu);
  const Floats i = clamp(-ua * t.by_uu), j = clamp(-va * t.by_vv), k = clamp(-wa * t.by_ww);
  const Floats on_u = i * fused(i, t.uu, ua + ua), on_v = j * fused(j, t.vv, va + va),
               on_w = fused(k, fused(k, t.ww, wa + wa), (ua + ua) + t.uu);
  const FloatMask on_v_is_nearer = on_v < on_u, on_w_is_nearest = on_w < least(on_u, on_v);
  const Floats along_u = choose(on_w_is_nearest, one - k, choose(on_v_is_nearer, zero, i));
  const Floats along_v = choose(on_w_is_nearest, k, or_zero(on_v_is_nearer, j));

  beside = (least_weight(t, ua, va) < zero) | (t.determinant <= all(0x1p-60F));
  const Floats side = dot(t.normal, to_a);
  const Triple<Floats> down{turned_like(t.normal.x, side), turned_like(t.normal.y, side),
                            turned_like(t.normal.z, side)};
  return choose(beside, along(along(to_a, along_v, t.v), along_u, t.u), down);
}

/// Of M, of the path since the entry, and of one unit of the leaf. \see the head of this file
constexpr float support_error = 0x1p-18F, path_error = 0x1p-20F, corner_error = 0x1p-22F;

/// The moving sphere in a leaf's unit, relative to the rounded centre at the time of entry.
struct InLeaf {
  float centre[4];              // rounded, from the leaf's origin
  Triple<Floats> rest, travel;  // what the rounding left; the displacement
  float radius, length;         // with the error of everything but the support; of the travel
  float slack, unsure;          // that error; and path.unsure
};

HWY_INLINE InLeaf in_leaf(const Path& path, const LeafHead& head, float time) {
  const double unit = power_of_two(-head.exponent);  // all that it multiplies stays exact
  const Doubles start = read<Doubles>(path.start) - from_floats(head.origin);
  const Doubles at = fused(all4(time), read<Doubles>(path.travel), start) * all4(unit);
  InLeaf s;
  float rest[4], travel[4];
  write(s.centre, at);
  write(rest, at - from_floats(s.centre));
  write(travel, from_floats(path.across) * all4(unit));
  s.rest = in_all(rest);
  s.travel = in_all(travel);
  const float scale = static_cast<float>(unit);
  s.radius = path.grown_radius * scale + corner_error;
  s.slack = static_cast<float>(path.error) * scale + corner_error;
  s.unsure = path.unsure * scale;
  s.length = path.length * scale;
  return s;
}

/// M, or a little more.
HWY_INLINE Floats about_size(const Triple<Floats>& to_a, const Triangles& t) {
  return fused(about_root(dot(to_a, to_a) + t.longest), all(1 + 0x1p-9F), all(0x1p-50F));
}

//! [raise]
/// What one Newton step finds: the triangles that are never touched, one bit each; how far the centre was from
/// each before the step, at least, and the sphere, negative if they may overlap; and whether the way to the
/// nearest point is known, and leads back: \see certain
struct Step {
  unsigned never;
  Floats distance, apart;
  FloatMask leaving;
};

/// Raises `later`, a time after the entry before which nothing is touched.
HWY_INLINE Step raise(const Triangles& t, const InLeaf& s, Floats& later) {
  const Triple<Floats> to_a = t.a - along(s.rest, later, s.travel);
  FloatMask beside;
  const Triple<Floats> q = about_nearest(t, to_a, beside);
  const Floats zero = all(0), rounded = all(path_error * s.length);
  const Floats support = dot(q, to_a) + least(zero, least(dot(q, t.u), dot(q, t.v)));
  // Not less than it is, also where squares underflow.
  const Floats q_length = root(dot(q, q) + all(0x1p-120F));
  const Floats size = about_size(to_a, t);
  const Floats reach = fused(rounded, later, fused(all(support_error), size, all(s.radius)));
  const Floats gap = minus_product(support, reach, q_length);
  const Floats speed = fused(rounded, q_length, dot(q, s.travel));
  const FloatMask separate = gap > zero;
  later = choose(separate, fused(gap / speed, all(1 - 0x1p-20F), later), later);
  Step step;
  step.never = bits(separate & (speed <= zero));
  step.distance = support / q_length;
  step.apart = step.distance - reach;
  const FloatMask known =
      beside & (step.distance > all(1 - 0x1p-14F) * q_length) & (all(16) * step.distance > size);
  step.leaving = known & (speed < all(-1 / 16.0F * s.length) * q_length);
  return step;
}
//! [raise]

}  // namespace first_contact::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
