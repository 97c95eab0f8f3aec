// Read once for each kind of processor.
#if defined(FIRST_CONTACT_BVH_KERNELS_CERTAIN_FACES) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRST_CONTACT_BVH_KERNELS_CERTAIN_FACES
#undef FIRST_CONTACT_BVH_KERNELS_CERTAIN_FACES
#else
#define FIRST_CONTACT_BVH_KERNELS_CERTAIN_FACES
#endif

#include "first_contact/bvh/kernels/support_bound.hpp"

/// \file
/// What floats can say for certain of eight faces: the sphere touches this one, before any other feature of
/// its triangle; or it overlaps it at the start, and only leaves.
///
/// The idea: the path meets the face moved out by r; if it lands inside all sides, by more than any rounding,
/// then nothing of the triangle is touched before. A sphere that reaches deep through the plane at the start,
/// with its centre over the face, touches it at once or never: \see deep() in features.hpp. So, as a rule, no
/// feature of a triangle has to be asked in doubles.
///
/// One that leaves the nearest point of what it overlaps, over the face or on a side, never touches it. The
/// distance is convex in time, so that it grows from then on, by 1/128 of the path at least. What is entered
/// when it is the nearest point, or nearest but for rounding, would have to come nearer; and what is not
/// nearest, the triangle itself hides (nearest.hpp). On a side, let q be the way to the point that is taken
/// for the nearest. If all of the triangle is (1 - 2^-14) |q| away at least, then, with 2^-14 |q| for the
/// rounding of each (2^-18 M), the nearest point is within the root of 1.5 2^-12 |q|^2 of it: the direction
/// is right to 1/50, and the sphere leaves q by 1/16 of the path.
///
/// The rounding, in the leaf's unit. A corner, relative to the centre, is off by less than `off`; the normal
/// by `bent`, twice as much as its four products with a side are; the height over the plane by `doubt`; the
/// landing by what the centre goes on in the time that is in doubt. Twice the areas at the sides, times the
/// normal, are less than side^3 times what the landing is off, and products with a rounded side. Each
/// constant is about twice what it has to be. Triangles too thin for this, with an angle of less than 1/32,
/// paths flatter than 1/64, and radii that are not small multiples of all lengths are left in doubt.

HWY_BEFORE_NAMESPACE();
namespace first_contact::bvh::HWY_NAMESPACE {

/// How high the corner a of each triangle is over the centre at the entry, along the normal, and how fast the
/// centre rises towards it; both times the normal's length.
struct Heights {
  Triple<Floats> to_a;
  Floats size;  // M
  Floats height, rise, length;
};
HWY_INLINE Heights heights(const Triangles& t, const InLeaf& s) {
  Heights h;
  h.to_a = t.a - s.rest;
  h.size = about_size(h.to_a, t);
  h.height = dot(t.normal, h.to_a);
  h.rise = dot(t.normal, s.travel);
  h.length = root(dot(t.normal, t.normal) + all(0x1p-120F));
  return h;
}

/// How far the floats may be wrong about a plane: its corner, its normal, the height over it, the speed.
struct Doubt {
  Floats off, bent, height, speed;
};
HWY_INLINE Doubt doubt_of(const InLeaf& s, const Heights& h, const Floats& side, const Floats& path) {
  Doubt doubt;
  doubt.off = all(corner_error) * (all(1) + h.size);
  doubt.bent = all(8) * doubt.off * side;
  doubt.height =
      fused(all(2) * doubt.bent, h.size, h.length * fused(all(0x1p-19F), h.size, all(2 * s.slack)));
  doubt.speed = fused(all(0x1p-20F), h.length, doubt.bent) * path;
  return doubt;
}

/// One bit each: the faces that are touched, by the time `late`; and the triangles that never are.
struct Certain {
  unsigned touched, never;
  Floats late;
};

//! [certain]
HWY_INLINE Certain certain(const Triangles& t, const InLeaf& s, const Heights& h, const Step& step,
                           bool at_start) {
  const Floats zero = all(0), path = all(s.length), side = root(t.longest);
  const Doubt doubt = doubt_of(s, h, side, path);

  // When is the plane moved out met? 0 if the plane is reached through.
  const Floats reach = all(s.radius) * h.length, height = magnitude(h.height), gap = height - reach;
  const Floats speed = turned_like(h.rise, h.height), by_speed = all(1) / speed;
  const FloatMask apart = gap > doubt.height;
  const Floats time = or_zero(apart, gap * by_speed);
  const Floats spread = or_zero(apart, all(2) * fused(time, doubt.speed, doubt.height) * by_speed);

  // Is the landing inside all sides?
  const Triple<Floats> landing = h.to_a - along({zero, zero, zero}, time, s.travel);
  const Floats far = fused(time, path, h.size);
  const Floats margin = t.longest * fused(side, fused(all(2) * spread, path, all(0x1p-16F) * far),
                                          all(32) * doubt.off * (side + far));
  const FloatMask inside = least_weight(t, dot(t.u, landing), dot(t.v, landing)) > margin;

  const FloatMask fat = (all(32) * h.length > t.longest) & (all(s.radius) < all(0x1p30F) * side);
  const FloatMask steep =
      magnitude(speed) > most(doubt.speed + doubt.speed, all(1 / 64.0F) * h.length * path);
  const FloatMask through = (height > doubt.height) & (gap < zero);
  const FloatMask deep = (gap < all(-1 / 32.0F) * reach) & (doubt.height < all(1 / 64.0F) * reach) &
                         (h.size + path < all(256) * all(s.radius));
  const unsigned over = bits(inside & fat & steep), closing = bits(speed > zero);
  if (!at_start) return {over & closing & bits(apart), 0, time + spread};
  return {over & closing & bits(apart | (through & deep)),
          (over & ~closing & bits(through)) | bits(step.leaving & fat & (step.apart < zero)), time + spread};
}
//! [certain]

}  // namespace first_contact::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
