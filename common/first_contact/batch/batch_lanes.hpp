#pragma once
#if defined(__AVX2__) && defined(__FMA__)
#include <immintrin.h>
#endif

/// \file
/// Four or eight doubles that are added, compared and chosen from as one, where the processor can; and one
/// double, by the same names.
///
/// The compiler's vector types know + - * / and the comparisons; what they have no sign for is written here.
/// Each operation is rounded once, as IEEE 754 has it, whichever of the types it is for: so the results are
/// equal.
///
/// All has internal linkage, and nothing of the standard library is used: what is compiled for one kind of
/// processor must not be taken by the linker for what runs everywhere.

namespace first_contact::batch {
namespace {

inline double read(const double* from, double) { return *from; }
inline void write(double* to, double a) { *to = a; }
inline double all(double a, double) { return a; }
inline double fused(double a, double b, double c) { return __builtin_fma(a, b, c); }
inline double root(double a) { return __builtin_sqrt(a); }
inline double magnitude(double a) { return __builtin_fabs(a); }
/// 1 with the sign of a.
inline double sign(double a) { return __builtin_copysign(1.0, a); }
inline double choose(bool which, double yes, double no) { return which ? yes : no; }
inline bool any(bool which) { return which; }

#if defined(__AVX2__) && defined(__FMA__)
#if defined(__AVX512F__)
using Doubles __attribute__((vector_size(64))) = double;
#else
using Doubles __attribute__((vector_size(32))) = double;
#endif
using Longs = decltype(Doubles{} < Doubles{});
using Widest = Doubles;

inline Doubles read(const double* from, Doubles a) {
  __builtin_memcpy(&a, from, sizeof a);
  return a;
}
inline void write(double* to, Doubles a) { __builtin_memcpy(to, &a, sizeof a); }
inline Doubles all(double a, Doubles) { return a - Doubles{}; }  // + would make 0 of -0
inline Doubles magnitude(Doubles a) { return (Doubles)((Longs)a & 0x7fffffffffffffff); }
inline Doubles sign(Doubles a) { return (Doubles)((Longs)all(1.0, a) | ((Longs)a ^ (Longs)magnitude(a))); }
inline Doubles choose(Longs which, Doubles yes, Doubles no) { return which ? yes : no; }

#if defined(__AVX512F__)
inline Doubles fused(Doubles a, Doubles b, Doubles c) {
  return (Doubles)_mm512_fmadd_pd((__m512d)a, (__m512d)b, (__m512d)c);
}
// The plain _mm512_sqrt_pd of g++ 12 warns of itself.
inline Doubles root(Doubles a) { return (Doubles)_mm512_maskz_sqrt_pd(0xff, (__m512d)a); }
inline bool any(Longs which) { return _mm512_test_epi64_mask((__m512i)which, (__m512i)which) != 0; }
#else
inline Doubles fused(Doubles a, Doubles b, Doubles c) {
  return (Doubles)_mm256_fmadd_pd((__m256d)a, (__m256d)b, (__m256d)c);
}
inline Doubles root(Doubles a) { return (Doubles)_mm256_sqrt_pd((__m256d)a); }
inline bool any(Longs which) { return !_mm256_testz_si256((__m256i)which, (__m256i)which); }
#endif

#else
using Widest = double;
#endif

/// How many doubles are taken at once.
constexpr unsigned lanes = sizeof(Widest) / sizeof(double);

}  // namespace
}  // namespace first_contact::batch
