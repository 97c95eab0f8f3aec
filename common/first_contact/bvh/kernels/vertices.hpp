// Read once for each kind of processor.
#if defined(FIRST_CONTACT_BVH_KERNELS_VERTICES) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRST_CONTACT_BVH_KERNELS_VERTICES
#undef FIRST_CONTACT_BVH_KERNELS_VERTICES
#else
#define FIRST_CONTACT_BVH_KERNELS_VERTICES
#endif

#include "first_contact/bvh/build/layout.hpp"
#include "first_contact/bvh/kernels/vectors.hpp"

/// \file
/// The corners of a leaf's eight triangles: from its sixteen vertices, by numbers of four bits.
///
/// The idea: a vertex that several triangles share is in memory once, and a processor with vectors of eight
/// floats picks it from a register for each of them.

HWY_BEFORE_NAMESPACE();
namespace first_contact::bvh::HWY_NAMESPACE {

/// Eight numbers of four bits, one a lane.
HWY_INLINE Ints unpacked(std::uint32_t packed) {
  using Tag = Ints::Tag;
  Ints numbers;
  for (std::size_t i = 0; i < Ints::parts; ++i) {
    const hn::RebindToUnsigned<Tag> u;
    const auto places = hn::Iota(u, static_cast<std::uint32_t>(i * Ints::per_part));
    const auto shifted = hn::Shr(hn::Set(u, packed), hn::ShiftLeft<2>(places));
    numbers.part[i] = hn::BitCast(Tag(), hn::And(shifted, hn::Set(u, 15U)));
  }
  return numbers;
}

#if HWY_MAX_BYTES >= 32

/// Sixteen floats, each less an origin. What is read after the last that there is, does not matter.
struct Sixteen {
  using Tag = Floats::Tag;
  HWY_INLINE Sixteen(const float* first, std::size_t count, float origin)
      : low(read<Floats>(first) - all(origin)), high(low), one_will_do(count <= 8) {
    if (!one_will_do) high = read<Floats>(first + 8) - all(origin);
  }
  HWY_INLINE Floats pick(const Ints& numbers) const {
    const auto indices = hn::IndicesFromVec(Tag(), hn::And(numbers.part[0], hn::Set(Ints::Tag(), 7)));
    const Floats from_low{{hn::TableLookupLanes(low.part[0], indices)}};
    if (one_will_do) return from_low;
    const Floats from_high{{hn::TableLookupLanes(high.part[0], indices)}};
    return choose(FloatMask{{hn::RebindMask(Tag(), hn::Gt(numbers.part[0], hn::Set(Ints::Tag(), 7)))}},
                  from_high, from_low);
  }
  Floats low, high;
  bool one_will_do;
};

#else

struct Sixteen {
  HWY_INLINE Sixteen(const float* values, std::size_t, float from) : first(values), origin(from) {}
  HWY_INLINE Floats pick(const Ints& numbers) const {
    Floats picked;
    for (std::size_t i = 0; i < Floats::parts; ++i)
      picked.part[i] = hn::GatherIndex(Floats::Tag(), first, numbers.part[i]);
    return picked - all(origin);
  }
  const float* first;
  float origin;
};

#endif

/// The corners a, b and c of eight triangles.
struct Corners {
  Triple<Floats> a, b, c;
};
HWY_INLINE Corners corners(const LeafHead& head, const float* origin) {
  const float* first = coordinates(head);
  const std::size_t n = head.vertices;
  const Sixteen x(first, n, origin[0]), y(first + n, n, origin[1]), z(first + 2 * n, n, origin[2]);
  const auto corner = [&](std::uint32_t packed) HWY_ATTR {
    const Ints numbers = unpacked(packed);
    return Triple<Floats>{x.pick(numbers), y.pick(numbers), z.pick(numbers)};
  };
  return {corner(head.corner[0]), corner(head.corner[1]), corner(head.corner[2])};
}

}  // namespace first_contact::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
