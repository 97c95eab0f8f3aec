// Read once for each kind of processor.
#if defined(FIRST_CONTACT_BVH_KERNELS_OVER_CONES) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRST_CONTACT_BVH_KERNELS_OVER_CONES
#undef FIRST_CONTACT_BVH_KERNELS_OVER_CONES
#else
#define FIRST_CONTACT_BVH_KERNELS_OVER_CONES
#endif

#include "first_contact/bvh/kernels/certain_faces.hpp"

/// \file
/// Over which triangles is the centre never, as far as they and their neighbours are turned? \see cones.hpp

HWY_BEFORE_NAMESPACE();
namespace first_contact::bvh::HWY_NAMESPACE {

/// One bit for each triangle over which the centre is not until `duration` after the entry.
///
/// One that the sphere overlaps at the start, by 1/200 of its radius, is touched then or never: its distance
/// is convex in time, so that when it gets to r it grows, by r / 200 a path at least; and nothing of it is
/// entered that is not nearest, but for rounding, which turns the direction to it less (`brief`).
/// \param distance  from the triangles, at least
HWY_INLINE unsigned never_over(const Path& path, const LeafHead& head, const InLeaf& s, const Heights& h,
                               float duration, const Floats& distance) {
  const Floats slack = fused(all(support_error), h.size, all(s.slack + path_error * s.length));
  const Floats sure = most(all(s.radius) - (slack + slack), all(0));
  const FloatMask overlapped = dot(h.to_a, h.to_a) < sure * sure * all(0.99F);
  const Floats later = magnitude(minus_product(h.height, all(duration), h.rise));
  const Floats highest = most(magnitude(h.height), path.brief ? choose(overlapped, all(0), later) : later);
  const Floats nearest = least(distance, all(s.radius)) - (slack + all(s.unsure));
  const Floats cosine = from_whole(head.cone) * all(1 / 255.0F);
  return bits(highest < (cosine * nearest - slack) * h.length);
}

}  // namespace first_contact::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
