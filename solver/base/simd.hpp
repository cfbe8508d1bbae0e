#pragma once

#include <array>
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

/// Writes first + l to `out` for every lane l with p[l] < limit, in order; returns the end.
/// `out` needs room for a whole pack.
inline std::uint16_t* append_less(Pack<float> p, float limit, std::uint16_t first,
                                  std::uint16_t* out) {
#if defined(__AVX512VBMI2__) && defined(__AVX512VL__)
  const __mmask16 near = _mm512_cmp_ps_mask(p, _mm512_set1_ps(limit), _CMP_LT_OQ);
  const __m256i ramp = _mm256_setr_epi16(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
  const __m256i ids = _mm256_add_epi16(ramp, _mm256_set1_epi16(static_cast<short>(first)));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(out), _mm256_maskz_compress_epi16(near, ids));
  return out + __builtin_popcount(near);
#else
  for (int l = 0; l < lanes<float>; ++l) {
    *out = static_cast<std::uint16_t>(first + l);
    out += p[l] < limit;
  }
  return out;
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

/// 1/x, to the precision of the type.
template <class P>
inline P inverse(P x) {
  return 1 / x;
}
#if defined(__AVX512F__)
template <>
inline Pack<float> inverse(Pack<float> x) {
  const Pack<float> y = _mm512_rcp14_ps(x);
  return y * (2.0f - x * y);
}
#endif

/// Four columns of a group of rows, one pack each.
template <class T>
struct Columns {
  Pack<T> c0, c1, c2, c3;
};

/// Loads numbers 4b..4b+3 of `lanes` rows: lane l of c_k is rows[index[l] * Stride + 4 b + k].
template <int Stride, class T>
inline Columns<T> load_transposed(const T* rows, const std::uint16_t* index, int b) {
  Columns<T> out;
  for (int l = 0; l < lanes<T>; ++l) {
    const T* row = rows + index[l] * Stride + 4 * b;
    out.c0[l] = row[0], out.c1[l] = row[1], out.c2[l] = row[2], out.c3[l] = row[3];
  }
  return out;
}
#if defined(__AVX512F__)
template <int Stride>
[[gnu::always_inline]] inline Columns<float> load_transposed(const float* rows,
                                                             const std::uint16_t* index, int b) {
  const auto quad = [&](int l) __attribute__((always_inline)) {
    return _mm_load_ps(rows + index[l] * Stride + 4 * b);
  };
  const auto gather = [&](int k) __attribute__((always_inline)) {
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
  return {_mm512_castpd_ps(_mm512_unpacklo_pd(lo01, lo23)),
          _mm512_castpd_ps(_mm512_unpackhi_pd(lo01, lo23)),
          _mm512_castpd_ps(_mm512_unpacklo_pd(hi01, hi23)),
          _mm512_castpd_ps(_mm512_unpackhi_pd(hi01, hi23))};
}
template <int Stride>
[[gnu::always_inline]] inline Columns<double> load_transposed(const double* rows,
                                                              const std::uint16_t* index, int b) {
  const auto quad = [&](int l) __attribute__((always_inline)) {
    return _mm256_load_pd(rows + index[l] * Stride + 4 * b);
  };
  const auto gather = [&](int k) __attribute__((always_inline)) {
    return _mm512_insertf64x4(_mm512_castpd256_pd512(quad(k)), quad(k + 4), 1);
  };
  const __m512d r0 = gather(0), r1 = gather(1), r2 = gather(2), r3 = gather(3);
  const __m512d xz01 = _mm512_unpacklo_pd(r0, r1), yw01 = _mm512_unpackhi_pd(r0, r1);
  const __m512d xz23 = _mm512_unpacklo_pd(r2, r3), yw23 = _mm512_unpackhi_pd(r2, r3);
  const __m512i low = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
  const __m512i high = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
  return {_mm512_permutex2var_pd(xz01, low, xz23), _mm512_permutex2var_pd(yw01, low, yw23),
          _mm512_permutex2var_pd(xz01, high, xz23), _mm512_permutex2var_pd(yw01, high, yw23)};
}
#endif

/// How many Pack<double> hold the lanes of one Pack<T>.
template <class T>
inline constexpr std::size_t parts = sizeof(double) / sizeof(T);

/// Part p of a pack in double precision.
template <class T>
inline Pack<double> widened(Pack<T> x, std::size_t p) {
  Pack<double> y;
  for (int l = 0; l < lanes<double>; ++l)
    y[l] = static_cast<double>(x[static_cast<int>(p) * lanes<double> + l]);
  return y;
}

#if defined(__AVX512F__)
template <>
inline Pack<double> widened<float>(Pack<float> x, std::size_t p) {
  return _mm512_cvtps_pd(p == 0 ? _mm512_castps512_ps256(x)
                                : _mm256_castpd_ps(_mm512_extractf64x4_pd(_mm512_castps_pd(x), 1)));
}
#endif

/// 0, 1, 2...: the index of rows that lie one after another.
template <class T>
inline constexpr auto rising = [] {
  std::array<std::uint16_t, lanes<T>> index{};
  for (std::size_t l = 0; l < index.size(); ++l) index[l] = static_cast<std::uint16_t>(l);
  return index;
}();

/// out[k] = sum over the lanes of in[k], always in the same order; `out` has room for a multiple
/// of 16.
template <int N, class T>
inline void lane_sums(const Pack<T> (&in)[N], T* out) {
  for (int k = 0; k < N; ++k) {
    alignas(vector_bytes) T a[lanes<T>];
    std::memcpy(a, &in[k], sizeof a);
    for (int n = lanes<T> / 2; n > 0; n /= 2)
      for (int l = 0; l < n; ++l) a[l] += a[l + n];
    out[k] = a[0];
  }
}
#if defined(__AVX512F__)
/// Sixteen at a time: a transpose that adds where it would only move.
template <int N>
[[gnu::always_inline]] inline void lane_sums(const Pack<float> (&in)[N], float* out) {
  const auto of = [&](int k) __attribute__((always_inline))->__m512 {
    return k < N ? in[k] : Pack<float>{};
  };
  const auto pair = [](__m512 a, __m512 b) __attribute__((always_inline)) {
    return _mm512_castps_pd(_mm512_add_ps(_mm512_unpacklo_ps(a, b), _mm512_unpackhi_ps(a, b)));
  };
  const auto four = [&](int k) __attribute__((always_inline)) {
    const __m512d ab = pair(of(k), of(k + 1)), cd = pair(of(k + 2), of(k + 3));
    return _mm512_add_ps(_mm512_castpd_ps(_mm512_unpacklo_pd(ab, cd)),
                         _mm512_castpd_ps(_mm512_unpackhi_pd(ab, cd)));
  };
  const auto quarters = [](__m512 a, __m512 b) __attribute__((always_inline)) {
    return _mm512_add_ps(_mm512_shuffle_f32x4(a, b, 0x88), _mm512_shuffle_f32x4(a, b, 0xdd));
  };
#pragma GCC unroll 4
  for (int k = 0; k < N; k += 16) {
    const __m512 low = quarters(four(k), k + 4 < N ? four(k + 4) : __m512{});
    const __m512 high = k + 8 < N ? quarters(four(k + 8), four(k + 12)) : __m512{};
    _mm512_storeu_ps(out + k, quarters(low, high));
  }
}
/// Eight at a time.
template <int N>
[[gnu::always_inline]] inline void lane_sums(const Pack<double> (&in)[N], double* out) {
  const auto of = [&](int k) __attribute__((always_inline))->__m512d {
    return k < N ? in[k] : Pack<double>{};
  };
  const auto pair = [&](int k) __attribute__((always_inline)) {
    return _mm512_add_pd(_mm512_unpacklo_pd(of(k), of(k + 1)),
                         _mm512_unpackhi_pd(of(k), of(k + 1)));
  };
  const auto quarters = [](__m512d a, __m512d b) __attribute__((always_inline)) {
    return _mm512_add_pd(_mm512_shuffle_f64x2(a, b, 0x88), _mm512_shuffle_f64x2(a, b, 0xdd));
  };
#pragma GCC unroll 4
  for (int k = 0; k < N; k += 8)
    _mm512_storeu_pd(out + k,
                     quarters(quarters(pair(k), pair(k + 2)), quarters(pair(k + 4), pair(k + 6))));
}
#endif

}  // namespace eerie
