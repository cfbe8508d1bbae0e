#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#if defined(__AVX512F__)
#include <immintrin.h>
#endif

/// The one place that knows vector registers. Physics is written once, on Pack<T>, with plain
/// operators; this file gives the width, the few functions that operators lack, and the loading
/// of scattered rows. No result depends on the thread, only on the width that was compiled in.
namespace eerie {

#if defined(__AVX512F__)
inline constexpr std::size_t vector_bytes = 64;
inline constexpr std::string_view vector_variant = "AVX-512";
#elif defined(__AVX__)
inline constexpr std::size_t vector_bytes = 32;
inline constexpr std::string_view vector_variant = "AVX";
#else
inline constexpr std::size_t vector_bytes = 16;
inline constexpr std::string_view vector_variant = "SSE2 (generic x86-64)";
#endif

template <class T>
struct PackOf {
  typedef T type __attribute__((vector_size(vector_bytes)));
};
/// As many T as fit one vector register; a GCC vector type, so + - * / and ?: work on it.
template <class T>
using Pack = typename PackOf<T>::type;
template <class T>
inline constexpr int lanes = static_cast<int>(vector_bytes / sizeof(T));

template <class T>
inline Pack<T> splat(T value) {
  return Pack<T>{} + value;
}

/// max(x, 0), lane by lane; works for scalars too.
template <class P>
inline P positive_part(P x) {
  return x > 0 ? x : P{};
}
#if defined(__AVX512F__)
template <>
inline Pack<float> positive_part(Pack<float> x) {
  return _mm512_max_ps(x, _mm512_setzero_ps());
}
template <>
inline Pack<double> positive_part(Pack<double> x) {
  return _mm512_max_pd(x, _mm512_setzero_pd());
}
#endif

/// Bit l is set where p[l] < limit.
inline std::uint32_t less_mask(Pack<float> p, float limit) {
#if defined(__AVX512F__)
  return _mm512_cmp_ps_mask(p, _mm512_set1_ps(limit), _CMP_LT_OQ);
#else
  std::uint32_t mask = 0;
  for (int l = 0; l < lanes<float>; ++l) mask |= static_cast<std::uint32_t>(p[l] < limit) << l;
  return mask;
#endif
}

/// 1/sqrt(x) for x > 0, to the precision of the type: an estimate with Newton steps where the
/// machine has one, else a square root and a division.
template <class P>
inline P inverse_sqrt(P x) {
  P y;
  for (std::size_t k = 0; k < sizeof(P) / sizeof(x[0]); ++k) y[k] = 1 / std::sqrt(x[k]);
  return y;
}
#if defined(__AVX512F__)
template <>
inline Pack<float> inverse_sqrt(Pack<float> x) {
  const Pack<float> y = _mm512_rsqrt14_ps(x);
  return y * (1.5f - 0.5f * x * y * y);
}
template <>
inline Pack<double> inverse_sqrt(Pack<double> x) {
  Pack<double> y = _mm512_rsqrt14_pd(x);
  y = y * (1.5 - 0.5 * x * y * y);
  return y * (1.5 - 0.5 * x * y * y);
}
#endif

/// Loads numbers 4b..4b+3 of `lanes` rows: out[c][l] = rows[index[l] * Stride + 4 b + c].
template <int Stride, class T>
inline void load_transposed(const T* rows, const std::uint16_t* index, int b, Pack<T> out[4]) {
  for (int l = 0; l < lanes<T>; ++l)
    for (int c = 0; c < 4; ++c) out[c][l] = rows[index[l] * Stride + 4 * b + c];
}
#if defined(__AVX512F__)
template <int Stride>
inline void load_transposed(const float* rows, const std::uint16_t* index, int b,
                            Pack<float> out[4]) {
  const auto quad = [&](int l) { return _mm_load_ps(rows + index[l] * Stride + 4 * b); };
  const auto gather = [&](int k) {
    __m512 r = _mm512_castps128_ps512(quad(k));
    r = _mm512_insertf32x4(r, quad(k + 4), 1);
    r = _mm512_insertf32x4(r, quad(k + 8), 2);
    return _mm512_insertf32x4(r, quad(k + 12), 3);
  };
  const __m512 r0 = gather(0), r1 = gather(1), r2 = gather(2), r3 = gather(3);
  const __m512d lo01 = _mm512_castps_pd(_mm512_unpacklo_ps(r0, r1));
  const __m512d hi01 = _mm512_castps_pd(_mm512_unpackhi_ps(r0, r1));
  const __m512d lo23 = _mm512_castps_pd(_mm512_unpacklo_ps(r2, r3));
  const __m512d hi23 = _mm512_castps_pd(_mm512_unpackhi_ps(r2, r3));
  out[0] = _mm512_castpd_ps(_mm512_unpacklo_pd(lo01, lo23));
  out[1] = _mm512_castpd_ps(_mm512_unpackhi_pd(lo01, lo23));
  out[2] = _mm512_castpd_ps(_mm512_unpacklo_pd(hi01, hi23));
  out[3] = _mm512_castpd_ps(_mm512_unpackhi_pd(hi01, hi23));
}
template <int Stride>
inline void load_transposed(const double* rows, const std::uint16_t* index, int b,
                            Pack<double> out[4]) {
  const auto quad = [&](int l) { return _mm256_load_pd(rows + index[l] * Stride + 4 * b); };
  const auto gather = [&](int k) {
    return _mm512_insertf64x4(_mm512_castpd256_pd512(quad(k)), quad(k + 4), 1);
  };
  const __m512d r0 = gather(0), r1 = gather(1), r2 = gather(2), r3 = gather(3);
  const __m512d xz01 = _mm512_unpacklo_pd(r0, r1), yw01 = _mm512_unpackhi_pd(r0, r1);
  const __m512d xz23 = _mm512_unpacklo_pd(r2, r3), yw23 = _mm512_unpackhi_pd(r2, r3);
  const __m512i low = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
  const __m512i high = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
  out[0] = _mm512_permutex2var_pd(xz01, low, xz23);
  out[1] = _mm512_permutex2var_pd(yw01, low, yw23);
  out[2] = _mm512_permutex2var_pd(xz01, high, xz23);
  out[3] = _mm512_permutex2var_pd(yw01, high, yw23);
}
#endif

/// Sum over the lanes, always in the same order (halves, quarters, ...).
template <class T>
inline T lane_sum(Pack<T> p) {
  alignas(vector_bytes) T a[lanes<T>];
  std::memcpy(a, &p, sizeof a);
  for (int n = lanes<T> / 2; n > 0; n /= 2)
    for (int l = 0; l < n; ++l) a[l] += a[l + n];
  return a[0];
}
#if defined(__AVX512F__)
template <>
inline float lane_sum(Pack<float> p) {
  return _mm512_reduce_add_ps(p);
}
template <>
inline double lane_sum(Pack<double> p) {
  return _mm512_reduce_add_pd(p);
}
#endif

}  // namespace eerie
