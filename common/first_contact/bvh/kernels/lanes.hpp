#pragma once
#include <cstdint>
#if defined(__AVX2__)
#include <immintrin.h>
#elif defined(__SSE2__)
#include <emmintrin.h>
#endif

/// \file
/// Eight floats that are added, compared and chosen from as one.
///
/// The idea: GCC's and clang's vector types know + - * / < and ?: on any machine; only what they have no sign
/// for is written here, once with AVX2's own instructions and once in plain loops. Whichever is compiled, the
/// results may differ in the last bits (fused or not, estimated or not); the bounds that are made of them
/// allow for that.
///
/// Everything here has internal linkage and uses nothing of the standard library: a function compiled with
/// AVX2 must never be taken by the linker for one that runs everywhere.

namespace first_contact::bvh {
namespace {

using Floats4 __attribute__((vector_size(16))) = float;
using Floats __attribute__((vector_size(32))) = float;
using Ints4 __attribute__((vector_size(16))) = std::int32_t;
using Ints __attribute__((vector_size(32))) = std::int32_t;
using Doubles __attribute__((vector_size(32))) = double;
using Longs __attribute__((vector_size(32))) = std::int64_t;

[[maybe_unused]] inline Floats all(float x) { return Floats{x, x, x, x, x, x, x, x}; }
[[maybe_unused]] inline Floats4 all_axes(float x) { return Floats4{x, x, x, x}; }
[[maybe_unused]] inline Floats4 to_floats(Doubles a) { return __builtin_convertvector(a, Floats4); }
[[maybe_unused]] inline Doubles to_doubles(Floats4 a) { return __builtin_convertvector(a, Doubles); }
[[maybe_unused]] inline double largest3(Doubles a) {
  const double b = a[0] > a[1] ? a[0] : a[1];
  return b > a[2] ? b : a[2];
}
[[maybe_unused]] inline Doubles all4(double x) { return Doubles{x, x, x, x}; }
[[maybe_unused]] inline Doubles magnitude(Doubles a) { return (Doubles)((Longs)a & 0x7fffffffffffffff); }
/// Each lane from the one two before it, round about: the last of three to the first place.
[[maybe_unused]] inline Doubles turn(Doubles a) { return Doubles{a[2], a[0], a[1], a[2]}; }
[[maybe_unused]] inline Floats4 magnitude(Floats4 a) { return (Floats4)((Ints4)a & 0x7fffffff); }
[[maybe_unused]] inline Floats magnitude(Floats a) { return (Floats)((Ints)a & 0x7fffffff); }
/// a, with its sign turned where b is negative.
[[maybe_unused]] inline Floats turned_like(Floats a, Floats b) {
  return (Floats)((Ints)a ^ ((Ints)b & static_cast<std::int32_t>(0x80000000u)));
}

/// Reads from any address.
template <class Value>
inline Value read(const void* from) {
  Value value;
  __builtin_memcpy(&value, from, sizeof value);
  return value;
}

[[maybe_unused]] inline void write(float* to, Floats4 a) { __builtin_memcpy(to, &a, sizeof a); }
[[maybe_unused]] inline void write(std::uint32_t* to, Ints a) { __builtin_memcpy(to, &a, sizeof a); }
[[maybe_unused]] inline void write(int* to, Ints4 a) { __builtin_memcpy(to, &a, sizeof a); }
[[maybe_unused]] inline void write(double* to, Doubles a) { __builtin_memcpy(to, &a, sizeof a); }

[[maybe_unused]] inline Ints all_ints(std::uint32_t x) { return Ints{} + static_cast<std::int32_t>(x); }
/// The lanes with a bit: all ones there, 0 elsewhere.
[[maybe_unused]] inline Ints lanes_of(unsigned bits) {
  return (all_ints(bits) & Ints{1, 2, 4, 8, 16, 32, 64, 128}) != 0;
}

//! [sorted]
/// One layer of a network that sorts: each lane becomes the larger or the smaller of itself and its partner.
template <int... partner>
inline Ints layer(Ints a, Ints larger) {
  const Ints b = __builtin_shufflevector(a, a, partner...);
  return larger ? (a > b ? a : b) : (a > b ? b : a);
}
/// The largest first: six layers (Batcher: Sorting Networks and Their Applications, 1968), and no jump that a
/// processor could guess wrong.
[[maybe_unused]] inline Ints sorted(Ints a) {
  a = layer<1, 0, 3, 2, 5, 4, 7, 6>(a, Ints{-1, 0, 0, -1, -1, 0, 0, -1});
  a = layer<2, 3, 0, 1, 6, 7, 4, 5>(a, Ints{-1, -1, 0, 0, 0, 0, -1, -1});
  a = layer<1, 0, 3, 2, 5, 4, 7, 6>(a, Ints{-1, 0, -1, 0, 0, -1, 0, -1});
  a = layer<4, 5, 6, 7, 0, 1, 2, 3>(a, Ints{-1, -1, -1, -1, 0, 0, 0, 0});
  a = layer<2, 3, 0, 1, 6, 7, 4, 5>(a, Ints{-1, -1, 0, 0, -1, -1, 0, 0});
  return layer<1, 0, 3, 2, 5, 4, 7, 6>(a, Ints{-1, 0, -1, 0, -1, 0, -1, 0});
}
/// The numbers of the lanes in `open`, that with the largest a first; after them the others. Of numbers that
/// differ in their last three bits only, any may come first.
[[maybe_unused]] inline Ints descending(Floats a, Ints open) {
  const Ints pattern = (Ints)a;
  const Ints key = pattern ^ (pattern >> 31 & 0x7fffffff);  // whole numbers in the same order
  return sorted(((open ? key : all_ints(0x80000000u)) & ~7) | Ints{0, 1, 2, 3, 4, 5, 6, 7}) & 7;
}
//! [sorted]

#if defined(__AVX2__)

/// Each lane from the one that `from` names.
inline Ints permute(Ints a, Ints from) {
  return (Ints)_mm256_permutevar8x32_epi32((__m256i)a, (__m256i)from);
}
inline Ints bytes(const std::uint8_t* p) {
  return (Ints)_mm256_cvtepu8_epi32(_mm_loadl_epi64((const __m128i*)p));
}
/// Not more than the root, nor less than .999 of it, unless that is less than 2^-50.
inline Floats about_root(Floats a) {
  return a * (Floats)_mm256_rsqrt_ps((__m256)(a + all(0x1p-100f))) * all(1 - 0x1p-11f);
}
/// Writes to any address, in one go: of what is then read singly no lane has to wait for another.
inline void write(float* to, Floats a) { _mm256_storeu_ps(to, (__m256)a); }
/// a < b ? a : b, and a > b ? a : b: if one is not a number, b.
inline Floats least(Floats a, Floats b) { return (Floats)_mm256_min_ps((__m256)a, (__m256)b); }
inline Floats most(Floats a, Floats b) { return (Floats)_mm256_max_ps((__m256)a, (__m256)b); }
inline Doubles least(Doubles a, Doubles b) { return (Doubles)_mm256_min_pd((__m256d)a, (__m256d)b); }
inline Doubles most(Doubles a, Doubles b) { return (Doubles)_mm256_max_pd((__m256d)a, (__m256d)b); }
/// One bit a lane: is it true?
inline unsigned bits(Ints mask) { return static_cast<unsigned>(_mm256_movemask_ps((__m256)mask)); }
inline unsigned bits4(Longs mask) { return static_cast<unsigned>(_mm256_movemask_pd((__m256d)mask)); }
inline Floats root(Floats a) { return (Floats)_mm256_sqrt_ps((__m256)a); }
inline Doubles root(Doubles a) { return (Doubles)_mm256_sqrt_pd((__m256d)a); }
/// 1 / a to 11 bits.
inline Floats about_one_over(Floats a) { return (Floats)_mm256_rcp_ps((__m256)a); }
inline Floats from_bytes(const std::uint8_t* p) { return (Floats)_mm256_cvtepi32_ps((__m256i)bytes(p)); }
inline Floats from_signed_bytes(const std::int8_t* p) {
  return (Floats)_mm256_cvtepi32_ps(_mm256_cvtepi8_epi32(_mm_loadl_epi64((const __m128i*)p)));
}
inline Floats from_shorts(const std::uint16_t* p) {
  return (Floats)_mm256_cvtepi32_ps(_mm256_cvtepu16_epi32(_mm_loadu_si128((const __m128i*)p)));
}
/// Eight 4-bit numbers, one a lane (the bits above them are left as they are).
inline Ints numbers(std::uint32_t packed) {
  const __m256i shift = _mm256_setr_epi32(0, 4, 8, 12, 16, 20, 24, 28);
  return (Ints)_mm256_srlv_epi32(_mm256_set1_epi32(static_cast<int>(packed)), shift);
}
/// Sixteen floats to pick from by numbers.
struct Table {
  Floats low, high;
  bool short_one;
};
inline Table table(const unsigned char* p, int count, float origin) {
  const Floats o = all(origin);
  return {read<Floats>(p) - o, count > 8 ? read<Floats>(p + 32) - o : o, count <= 8};
}
inline Floats pick(const Table& t, Ints n) {
  const __m256 low = _mm256_permutevar8x32_ps((__m256)t.low, (__m256i)n);
  if (t.short_one) return (Floats)low;
  const __m256 high = _mm256_permutevar8x32_ps((__m256)t.high, (__m256i)n);
  return (Floats)_mm256_blendv_ps(low, high, (__m256)(n << 28));
}

#else

inline Ints permute(Ints a, Ints from) {
  Ints result;
  for (int i = 0; i < 8; ++i) result[i] = a[from[i]];
  return result;
}
inline Ints bytes(const std::uint8_t* p) {
  Ints result;
  for (int i = 0; i < 8; ++i) result[i] = p[i];
  return result;
}
inline void write(float* to, Floats a) { __builtin_memcpy(to, &a, sizeof a); }
inline Floats least(Floats a, Floats b) { return a < b ? a : b; }
inline Floats most(Floats a, Floats b) { return a > b ? a : b; }
inline Doubles least(Doubles a, Doubles b) { return a < b ? a : b; }
inline Doubles most(Doubles a, Doubles b) { return a > b ? a : b; }
inline unsigned bits(Ints mask) {
#if defined(__SSE2__)
  const auto half = [&](int i) {
    return static_cast<unsigned>(_mm_movemask_ps(read<__m128>((const char*)&mask + i)));
  };
  return half(0) | half(16) << 4;
#else
  unsigned result = 0;
  for (int i = 0; i < 8; ++i) result |= (static_cast<unsigned>(mask[i]) >> 31) << i;
  return result;
#endif
}
inline unsigned bits4(Longs mask) {
  unsigned result = 0;
  for (int i = 0; i < 4; ++i) result |= mask[i] < 0 ? 1u << i : 0u;
  return result;
}
inline Floats root(Floats a) {
  for (int i = 0; i < 8; ++i) a[i] = __builtin_sqrtf(a[i]);
  return a;
}
inline Doubles root(Doubles a) {
  for (int i = 0; i < 4; ++i) a[i] = __builtin_sqrt(a[i]);
  return a;
}
inline Floats about_one_over(Floats a) { return 1.0f / a; }
inline Floats about_root(Floats a) { return root(a); }
template <class Number>
inline Floats from_numbers(const Number* p) {
  Floats result;
  for (int i = 0; i < 8; ++i) result[i] = static_cast<float>(p[i]);
  return result;
}
inline Floats from_bytes(const std::uint8_t* p) { return from_numbers(p); }
inline Floats from_signed_bytes(const std::int8_t* p) { return from_numbers(p); }
inline Floats from_shorts(const std::uint16_t* p) { return from_numbers(p); }
inline Ints numbers(std::uint32_t packed) {
  Ints result;
  for (int i = 0; i < 8; ++i) result[i] = static_cast<std::int32_t>(packed >> 4 * i & 15);
  return result;
}
struct Table {
  const unsigned char* first;
  float origin;
};
inline Table table(const unsigned char* p, int, float origin) { return {p, origin}; }
inline Floats pick(const Table& t, Ints n) {
  Floats result;
  for (int i = 0; i < 8; ++i) result[i] = read<float>(t.first + 4 * n[i]);
  return result - t.origin;
}

#endif

}  // namespace
}  // namespace first_contact::bvh
