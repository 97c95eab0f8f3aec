// Read once for each kind of processor.
#if defined(FIRST_CONTACT_BVH_KERNELS_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRST_CONTACT_BVH_KERNELS_LANES
#undef FIRST_CONTACT_BVH_KERNELS_LANES
#else
#define FIRST_CONTACT_BVH_KERNELS_LANES
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

/// \file
/// Eight floats, or four doubles, that are added, compared and chosen from as one.
///
/// The idea: Google Highway knows the vectors of each processor, which hold four floats, eight or more; here
/// eight are always taken together, in as many vectors as that needs. What is rounded may differ in the last
/// bits from one processor to another (fused or not, estimated or not); the bounds that are made of it allow
/// for that.

HWY_BEFORE_NAMESPACE();
namespace first_contact::bvh::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// So many numbers of one kind. An operator does the same to each.
template <class Number, std::size_t count>
struct Lanes {
  using Tag = hn::CappedTag<Number, count>;
  static constexpr std::size_t parts = count / hn::MaxLanes(Tag()), per_part = count / parts;
  hn::Vec<Tag> part[parts];
};
/// What a comparison says of each lane.
template <class Number, std::size_t count>
struct Mask {
  static constexpr std::size_t parts = Lanes<Number, count>::parts;
  hn::Mask<typename Lanes<Number, count>::Tag> part[parts];
};

using Floats = Lanes<float, 8>;
using Ints = Lanes<std::int32_t, 8>;
using Doubles = Lanes<double, 4>;
using FloatMask = Mask<float, 8>;
using DoubleMask = Mask<double, 4>;

/// The same number in all lanes.
template <class Many, class Number>
HWY_INLINE Many all_lanes(Number x) {
  Many a;
  for (auto& part : a.part) part = hn::Set(typename Many::Tag(), x);
  return a;
}
HWY_INLINE Floats all(float x) { return all_lanes<Floats>(x); }
HWY_INLINE Ints all_ints(std::int32_t x) { return all_lanes<Ints>(x); }
HWY_INLINE Doubles all4(double x) { return all_lanes<Doubles>(x); }

/// Reads from any address.
template <class Many, class Number>
HWY_INLINE Many read(const Number* from) {
  Many a;
  for (std::size_t i = 0; i < Many::parts; ++i)
    a.part[i] = hn::LoadU(typename Many::Tag(), from + i * Many::per_part);
  return a;
}
/// Writes to any address.
template <class Number, std::size_t n>
HWY_INLINE void write(Number* to, const Lanes<Number, n>& a) {
  using Many = Lanes<Number, n>;
  for (std::size_t i = 0; i < Many::parts; ++i)
    hn::StoreU(a.part[i], typename Many::Tag(), to + i * Many::per_part);
}

template <class N, std::size_t n>
HWY_INLINE Lanes<N, n> operator+(Lanes<N, n> a, const Lanes<N, n>& b) {
  for (std::size_t i = 0; i < a.parts; ++i) a.part[i] = hn::Add(a.part[i], b.part[i]);
  return a;
}
template <class N, std::size_t n>
HWY_INLINE Lanes<N, n> operator-(Lanes<N, n> a, const Lanes<N, n>& b) {
  for (std::size_t i = 0; i < a.parts; ++i) a.part[i] = hn::Sub(a.part[i], b.part[i]);
  return a;
}
template <class N, std::size_t n>
HWY_INLINE Lanes<N, n> operator-(Lanes<N, n> a) {
  for (std::size_t i = 0; i < a.parts; ++i) a.part[i] = hn::Neg(a.part[i]);
  return a;
}
template <class N, std::size_t n>
HWY_INLINE Lanes<N, n> operator*(Lanes<N, n> a, const Lanes<N, n>& b) {
  for (std::size_t i = 0; i < a.parts; ++i) a.part[i] = hn::Mul(a.part[i], b.part[i]);
  return a;
}
template <class N, std::size_t n>
HWY_INLINE Lanes<N, n> operator/(Lanes<N, n> a, const Lanes<N, n>& b) {
  for (std::size_t i = 0; i < a.parts; ++i) a.part[i] = hn::Div(a.part[i], b.part[i]);
  return a;
}
/// a b + c, and c - a b; rounded once where the processor can.
template <class N, std::size_t n>
HWY_INLINE Lanes<N, n> fused(const Lanes<N, n>& a, const Lanes<N, n>& b, Lanes<N, n> c) {
  for (std::size_t i = 0; i < c.parts; ++i) c.part[i] = hn::MulAdd(a.part[i], b.part[i], c.part[i]);
  return c;
}
template <class N, std::size_t n>
HWY_INLINE Lanes<N, n> minus_product(Lanes<N, n> c, const Lanes<N, n>& a, const Lanes<N, n>& b) {
  for (std::size_t i = 0; i < c.parts; ++i) c.part[i] = hn::NegMulAdd(a.part[i], b.part[i], c.part[i]);
  return c;
}

template <class N, std::size_t n>
HWY_INLINE Mask<N, n> operator<(const Lanes<N, n>& a, const Lanes<N, n>& b) {
  Mask<N, n> m;
  for (std::size_t i = 0; i < m.parts; ++i) m.part[i] = hn::Lt(a.part[i], b.part[i]);
  return m;
}
template <class N, std::size_t n>
HWY_INLINE Mask<N, n> operator>(const Lanes<N, n>& a, const Lanes<N, n>& b) {
  return b < a;
}
template <class N, std::size_t n>
HWY_INLINE Mask<N, n> operator<=(const Lanes<N, n>& a, const Lanes<N, n>& b) {
  Mask<N, n> m;
  for (std::size_t i = 0; i < m.parts; ++i) m.part[i] = hn::Le(a.part[i], b.part[i]);
  return m;
}
template <class N, std::size_t n>
HWY_INLINE Mask<N, n> operator&(Mask<N, n> a, const Mask<N, n>& b) {
  for (std::size_t i = 0; i < a.parts; ++i) a.part[i] = hn::And(a.part[i], b.part[i]);
  return a;
}
template <class N, std::size_t n>
HWY_INLINE Mask<N, n> operator|(Mask<N, n> a, const Mask<N, n>& b) {
  for (std::size_t i = 0; i < a.parts; ++i) a.part[i] = hn::Or(a.part[i], b.part[i]);
  return a;
}

/// One bit a lane: is it true?
template <class N, std::size_t n>
HWY_INLINE unsigned bits(const Mask<N, n>& m) {
  using Many = Lanes<N, n>;
  unsigned result = 0;
  for (std::size_t i = 0; i < m.parts; ++i) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(typename Many::Tag(), m.part[i], bytes);
    result |= unsigned{bytes[0]} << (i * Many::per_part);
  }
  return result;
}

template <class N, std::size_t n>
HWY_INLINE Lanes<N, n> choose(const Mask<N, n>& m, const Lanes<N, n>& yes, Lanes<N, n> no) {
  for (std::size_t i = 0; i < m.parts; ++i) no.part[i] = hn::IfThenElse(m.part[i], yes.part[i], no.part[i]);
  return no;
}
/// yes, or 0.
template <class N, std::size_t n>
HWY_INLINE Lanes<N, n> or_zero(const Mask<N, n>& m, Lanes<N, n> yes) {
  for (std::size_t i = 0; i < m.parts; ++i) yes.part[i] = hn::IfThenElseZero(m.part[i], yes.part[i]);
  return yes;
}
/// a < b ? a : b, and a > b ? a : b: if one is not a number, b. This is what Min and Max are on x86.
template <class N, std::size_t n>
HWY_INLINE Lanes<N, n> least(Lanes<N, n> a, const Lanes<N, n>& b) {
#if HWY_ARCH_X86 && HWY_TARGET != HWY_EMU128
  for (std::size_t i = 0; i < a.parts; ++i) a.part[i] = hn::Min(a.part[i], b.part[i]);
  return a;
#else
  return choose(a < b, a, b);
#endif
}
template <class N, std::size_t n>
HWY_INLINE Lanes<N, n> most(Lanes<N, n> a, const Lanes<N, n>& b) {
#if HWY_ARCH_X86 && HWY_TARGET != HWY_EMU128
  for (std::size_t i = 0; i < a.parts; ++i) a.part[i] = hn::Max(a.part[i], b.part[i]);
  return a;
#else
  return choose(a > b, a, b);
#endif
}

template <class N, std::size_t n>
HWY_INLINE Lanes<N, n> magnitude(Lanes<N, n> a) {
  for (auto& part : a.part) part = hn::Abs(part);
  return a;
}
template <class N, std::size_t n>
HWY_INLINE Lanes<N, n> root(Lanes<N, n> a) {
  for (auto& part : a.part) part = hn::Sqrt(part);
  return a;
}
/// a, with its sign turned where b is negative.
HWY_INLINE Floats turned_like(Floats a, const Floats& b) {
  const auto sign = hn::SignBit(Floats::Tag());
  for (std::size_t i = 0; i < a.parts; ++i) a.part[i] = hn::Xor(a.part[i], hn::And(sign, b.part[i]));
  return a;
}
/// About 1 / a: to a hundredth or better.
HWY_INLINE Floats about_one_over(Floats a) {
  for (auto& part : a.part) part = hn::ApproximateReciprocal(part);
  return a;
}
/// Not more than the root, nor less than .999 of it, unless that is less than 2^-50. Estimates of x86 are
/// right to 2^-11.4; others are not good enough.
HWY_INLINE Floats about_root(const Floats& a) {
#if HWY_ARCH_X86 && HWY_TARGET != HWY_EMU128
  Floats estimate = a + all(0x1p-100f);
  for (auto& part : estimate.part) part = hn::ApproximateReciprocalSqrt(part);
  return a * estimate * all(1 - 0x1p-11f);
#else
  return root(a);
#endif
}

/// Eight small whole numbers as floats.
template <class Small>
HWY_INLINE Floats from_whole(const Small* p) {
  Floats a;
  for (std::size_t i = 0; i < a.parts; ++i) {
    const auto small = hn::LoadU(hn::Rebind<Small, Floats::Tag>(), p + i * Floats::per_part);
    a.part[i] = hn::ConvertTo(Floats::Tag(), hn::PromoteTo(Ints::Tag(), small));
  }
  return a;
}
/// Floats as doubles, and the other way round.
HWY_INLINE Doubles from_floats(const float* from) {
  Doubles a;
  for (std::size_t i = 0; i < a.parts; ++i) {
    const auto floats = hn::LoadU(hn::Rebind<float, Doubles::Tag>(), from + i * Doubles::per_part);
    a.part[i] = hn::PromoteTo(Doubles::Tag(), floats);
  }
  return a;
}
HWY_INLINE void write(float* to, const Doubles& a) {
  constexpr hn::Rebind<float, Doubles::Tag> floats;
  for (std::size_t i = 0; i < a.parts; ++i)
    hn::StoreU(hn::DemoteTo(floats, a.part[i]), floats, to + i * Doubles::per_part);
}
/// The bits of floats as whole numbers: of floats that are not negative, in the same order.
HWY_INLINE Ints patterns(const Floats& a) {
  Ints b;
  for (std::size_t i = 0; i < a.parts; ++i) b.part[i] = hn::BitCast(Ints::Tag(), a.part[i]);
  return b;
}
HWY_INLINE Ints operator&(Ints a, const Ints& b) {
  for (std::size_t i = 0; i < a.parts; ++i) a.part[i] = hn::And(a.part[i], b.part[i]);
  return a;
}
HWY_INLINE Ints operator|(Ints a, const Ints& b) {
  for (std::size_t i = 0; i < a.parts; ++i) a.part[i] = hn::Or(a.part[i], b.part[i]);
  return a;
}

}  // namespace first_contact::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
