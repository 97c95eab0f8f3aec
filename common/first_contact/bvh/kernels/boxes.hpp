// Read once for each kind of processor.
#if defined(FIRST_CONTACT_BVH_KERNELS_BOXES) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRST_CONTACT_BVH_KERNELS_BOXES
#undef FIRST_CONTACT_BVH_KERNELS_BOXES
#else
#define FIRST_CONTACT_BVH_KERNELS_BOXES
#endif

#include "first_contact/bvh/kernels/lanes.hpp"
#include "first_contact/bvh/kernels/progress.hpp"

/// \file
/// Which children of a node can the sphere touch, and when does it come near each of them?
///
/// The idea: eight boxes at once, each grown by the radius, against the path of the centre (the slab test
/// of Kay and Kajiya, 1986). The children's coordinates are small whole numbers q, and a side of a box is
/// at origin + q step: when the centre passes it, is one multiplication and one addition. It equals the test
/// of the plain tree, box by box.
///
/// Why it never rejects wrongly: times |travel|, each number here is a distance of at most farthest + r, and
/// is rounded fewer than twelve times, by 2^-24 of it. The boxes are grown by sixty-four roundings, box_error.

HWY_BEFORE_NAMESPACE();
namespace first_contact::bvh::HWY_NAMESPACE {

/// When the path is inside each of eight boxes, or along one axis between its sides.
struct Inside {
  Floats enter, leave;
};

HWY_INLINE Inside between_sides(const Path& path, const Node& node, int i) {
  const Floats inverse = all(path.inverse[i]), origin = all(node.origin[i]),
               step = all(node.step[i]) * inverse;
  const auto passes = [&](int side, float time) HWY_ATTR {
    return fused(from_whole(node.side[side]), step, fused(origin, inverse, all(time)));
  };
  return {passes(path.near_side[i], path.in[i]), passes(path.far_side[i], path.out[i])};
}

/// When the path is inside the children's boxes, of the times from 0 to `latest`. (Where `enter` is not a
/// number, it is 0, and `leave` is `latest`.)
HWY_INLINE Inside inside_boxes(const Path& path, const Node& node, float latest) {
  const Inside x = between_sides(path, node, 0), y = between_sides(path, node, 1),
               z = between_sides(path, node, 2);
  return {most(most(x.enter, y.enter), most(z.enter, all(0))),
          least(least(x.leave, y.leave), least(z.leave, all(latest)))};
}

}  // namespace first_contact::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
