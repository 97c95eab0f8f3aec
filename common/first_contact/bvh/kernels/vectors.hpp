// Read once for each kind of processor.
#if defined(FIRST_CONTACT_BVH_KERNELS_VECTORS) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRST_CONTACT_BVH_KERNELS_VECTORS
#undef FIRST_CONTACT_BVH_KERNELS_VECTORS
#else
#define FIRST_CONTACT_BVH_KERNELS_VECTORS
#endif

#include "first_contact/bvh/kernels/lanes.hpp"

/// \file
/// Vectors of space, one a lane.

HWY_BEFORE_NAMESPACE();
namespace first_contact::bvh::HWY_NAMESPACE {

template <class Number>
struct Triple {
  Number x, y, z;
};
template <class N>
HWY_INLINE Triple<N> operator-(const Triple<N>& a, const Triple<N>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class N>
HWY_INLINE N dot(const Triple<N>& a, const Triple<N>& b) {
  return fused(a.x, b.x, fused(a.y, b.y, a.z * b.z));
}
template <class N>
HWY_INLINE Triple<N> cross(const Triple<N>& a, const Triple<N>& b) {
  return {minus_product(a.y * b.z, a.z, b.y), minus_product(a.z * b.x, a.x, b.z),
          minus_product(a.x * b.y, a.y, b.x)};
}
/// p + s v
template <class N>
HWY_INLINE Triple<N> along(const Triple<N>& p, const N& s, const Triple<N>& v) {
  return {fused(s, v.x, p.x), fused(s, v.y, p.y), fused(s, v.z, p.z)};
}
template <class N, class Which>
HWY_INLINE Triple<N> choose(const Which& which, const Triple<N>& yes, const Triple<N>& no) {
  return {choose(which, yes.x, no.x), choose(which, yes.y, no.y), choose(which, yes.z, no.z)};
}
/// The same vector in all lanes.
HWY_INLINE Triple<Floats> in_all(const float* p) { return {all(p[0]), all(p[1]), all(p[2])}; }
HWY_INLINE Triple<Doubles> in_all(const double* p) { return {all4(p[0]), all4(p[1]), all4(p[2])}; }

}  // namespace first_contact::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
