// Read once for each kind of processor.
#if defined(FIRST_CONTACT_BVH_KERNELS_SLABS) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRST_CONTACT_BVH_KERNELS_SLABS
#undef FIRST_CONTACT_BVH_KERNELS_SLABS
#else
#define FIRST_CONTACT_BVH_KERNELS_SLABS
#endif

#include "first_contact/bvh/kernels/boxes.hpp"
#include "first_contact/bvh/kernels/vectors.hpp"

/// \file
/// Does the centre, over the part of its path inside a child's grown box, stay on one side of all that the
/// child holds, measured along the child's mean normal?
///
/// The idea: terrain is flat when seen from near: its boxes are thick where its slabs are thin. For spheres
/// much smaller than a leaf it is left out. The same heights tell whether the centre is ever over what the
/// child holds, as far as that is turned: \see cones.hpp.

HWY_BEFORE_NAMESPACE();
namespace first_contact::bvh::HWY_NAMESPACE {

//! [slabs]
/// The children whose slab the centre reaches while it is inside their box, and over which it then is, as far
/// as they are turned: high over a touched point by the cosine of the distance at least, which is the radius
/// where it is not there from the start. Heights are in 127ths.
HWY_INLINE unsigned within_slabs(const Path& path, const Node& node, const Inside& box) {
  const Triple<Floats> normal{from_whole(node.normal[0]), from_whole(node.normal[1]),
                              from_whole(node.normal[2])};
  const Floats height = dot(normal, in_all(path.from) - in_all(node.origin));
  const Floats rise = dot(normal, in_all(path.across));
  const Floats first = fused(rise, box.enter, height), last = fused(rise, box.leave, height);
  const float half = 127 * 255 * (node.step[0] + node.step[1] + node.step[2]);
  const float slack = 127 * path.slab_slack + half * box_error;
  const Floats step = all(half * (2 / 65535.0F)), reached = all(127 * path.reach);
  const Floats low = fused(from_whole(node.slab[0]), step, all(-half - slack)),
               high = fused(from_whole(node.slab[1]), step, all(-half + slack));
  const Floats above = least(first, last) - high, below = low - most(first, last);
  const Floats distance = or_zero(box.enter > all(0), all(path.bare * (127 / 255.0F)));
  const Floats cosine = from_whole(node.cone);
  return ~bits((most(above, below) > reached) | (most(-above, -below) < cosine * distance));
}
//! [slabs]

}  // namespace first_contact::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
