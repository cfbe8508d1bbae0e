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

/// This is the one file that knows vector registers. Physics is written once, on Pack<T>, with
/// plain operators. This file adds the width, the few functions that operators lack, and the
/// loading of scattered rows. Results depend on the compiled width and never on the thread.
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
/// As many T as fit into one vector register. It is a vector type of GCC, so + - * / and ?: work on
/// it.
template <class T>
using Pack = typename PackOf<T>::type;
template <class T>
inline constexpr int lanes = static_cast<int>(vector_bytes / sizeof(T));

template <class T>
struct QuadOf {
  typedef T type __attribute__((vector_size(4 * sizeof(T))));
};
/// Four numbers that belong together, such as a row of a matrix and one further number.
template <class T>
using Quad = typename QuadOf<T>::type;

template <class T>
inline Pack<T> splat(T value) {
  return Pack<T>{} + value;
}

/// max(x, 0) in each lane. It takes scalars too.
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

/// 1/sqrt(x) for x > 0, to the precision of the type. It refines the machine's estimate with Newton
/// steps; machines without an estimate take a square root and a division.
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

// Rows of eight or sixteen numbers. A *place* says where a row begins, in row units of eight bytes:
// the processor multiplies an address by eight at no cost.

/// The length of a row of eight numbers, in row units.
template <class T>
inline constexpr std::size_t row_units = sizeof(T);

template <class T>
inline const T* row_at(const T* rows, std::size_t place) {
  return reinterpret_cast<const T*>(reinterpret_cast<const char*>(rows) + 8 * place);
}

/// Eight columns of a group of rows, one pack each.
template <class T>
struct Columns {
  Pack<T> c[8];
};

/// Loads one row of eight per lane: lane l of c[k] is number k of the row at place[l].
template <class T>
inline Columns<T> load_columns(const T* rows, const std::uint16_t* place) {
  Columns<T> out;
  for (int l = 0; l < lanes<T>; ++l) {
    const T* row = row_at(rows, place[l]);
    for (int k = 0; k < 8; ++k) out.c[k][l] = row[k];
  }
  return out;
}

/// Writes numbers a, b, c, d of lane l to out + quad_place<T>(l); `out` has room for four packs.
template <class T>
inline void store_quads(Pack<T> a, Pack<T> b, Pack<T> c, Pack<T> d, T* out) {
  for (int l = 0; l < lanes<T>; ++l, out += 4)
    out[0] = a[l], out[1] = b[l], out[2] = c[l], out[3] = d[l];
}
template <class T>
constexpr int quad_place(int lane) {
#if defined(__AVX512F__)
  if constexpr (sizeof(T) == 4) return 16 * (lane % 4) + lane / 4 * 4;
  if constexpr (sizeof(T) == 8) return 16 * (lane % 2) + lane / 2 * 4;
#endif
  return 4 * lane;
}

/// A weighted sum of rows of sixteen numbers, that is four quads: s[4 a + k] = sum over rows of
/// row[4 a + k] weight[k]. The sum is kept in two or four parts, so that additions need not wait
/// for one another.
template <class T>
struct QuadSums {
  static constexpr int packs = 16 / lanes<T>, chains = packs == 1 ? 4 : packs == 2 ? 2 : 1;
  Pack<T> parts[chains][packs] = {};

  /// Adds a row for each lane; `place` in units of rows of eight.
  [[gnu::always_inline]] void add(const T* weights, const T* rows, const std::uint16_t* place) {
#pragma GCC unroll 16
    for (int l = 0; l < lanes<T>; ++l) {
      const T* row = row_at(rows, std::size_t{2} * place[l]);
      for (int p = 0; p < packs; ++p)
        parts[l % chains][p] += repeated(weights + quad_place<T>(l), p) * pack(row + p * lanes<T>);
    }
  }
  void store(T* out) const {
    for (int p = 0; p < packs; ++p) {
      Pack<T> sum = parts[0][p];
      for (int c = 1; c < chains; ++c) sum += parts[c][p];
      std::memcpy(out + p * lanes<T>, &sum, sizeof sum);
    }
  }

 private:
  static Pack<T> pack(const T* from) {
    Pack<T> p;
    std::memcpy(&p, from, sizeof p);
    return p;
  }
  /// Pack p of a row that repeats one quad.
  static Pack<T> repeated(const T* quad, int p) {
#if defined(__AVX512F__)
    if constexpr (sizeof(T) == 4)
      return _mm512_broadcast_f32x4(_mm_load_ps(quad));
    else
      return _mm512_broadcast_f64x4(_mm256_load_pd(quad));
#endif
    Pack<T> out;
    for (int l = 0; l < lanes<T>; ++l) out[l] = quad[(p * lanes<T> + l) % 4];
    return out;
  }
};

#if defined(__AVX512F__)
template <>
[[gnu::always_inline]] inline Columns<float> load_columns(const float* rows,
                                                          const std::uint16_t* place) {
  __m512d pair[8];  // rows k and k + 8; each round then joins more of one column
#pragma GCC unroll 8
  for (int k = 0; k < 8; ++k)
    pair[k] = _mm512_insertf64x4(
        _mm512_castps_pd(_mm512_castps256_ps512(_mm256_load_ps(row_at(rows, place[k])))),
        _mm256_castps_pd(_mm256_load_ps(row_at(rows, place[k + 8]))), 1);
  __m512d two[8], four[8];
#pragma GCC unroll 4
  for (int k = 0; k < 8; k += 2) {
    const __m512 a = _mm512_castpd_ps(pair[k]), b = _mm512_castpd_ps(pair[k + 1]);
    two[k] = _mm512_castps_pd(_mm512_unpacklo_ps(a, b));
    two[k + 1] = _mm512_castps_pd(_mm512_unpackhi_ps(a, b));
  }
#pragma GCC unroll 4
  for (int k : {0, 1, 4, 5}) {
    four[k / 4 * 4 + k % 4 * 2] = _mm512_unpacklo_pd(two[k], two[k + 2]);
    four[k / 4 * 4 + k % 4 * 2 + 1] = _mm512_unpackhi_pd(two[k], two[k + 2]);
  }
  const __m512i low = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
  const __m512i high = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
  Columns<float> out;
#pragma GCC unroll 4
  for (int k = 0; k < 4; ++k) {
    out.c[k] = _mm512_castpd_ps(_mm512_permutex2var_pd(four[k], low, four[k + 4]));
    out.c[k + 4] = _mm512_castpd_ps(_mm512_permutex2var_pd(four[k], high, four[k + 4]));
  }
  return out;
}
template <>
[[gnu::always_inline]] inline Columns<double> load_columns(const double* rows,
                                                           const std::uint16_t* place) {
  __m512d two[8], four[8];
#pragma GCC unroll 4
  for (int k = 0; k < 8; k += 2) {
    const __m512d a = _mm512_load_pd(row_at(rows, place[k])),
                  b = _mm512_load_pd(row_at(rows, place[k + 1]));
    two[k] = _mm512_unpacklo_pd(a, b);
    two[k + 1] = _mm512_unpackhi_pd(a, b);
  }
  // 128-bit lane q of two[k] has column 2 q (+ 1 if k is odd) of rows k and k + 1.
#pragma GCC unroll 4
  for (int k : {0, 1, 4, 5}) {
    four[k / 4 * 4 + k % 4 * 2] = _mm512_shuffle_f64x2(two[k], two[k + 2], 0x88);
    four[k / 4 * 4 + k % 4 * 2 + 1] = _mm512_shuffle_f64x2(two[k], two[k + 2], 0xdd);
  }
  Columns<double> out;
#pragma GCC unroll 4
  for (int k = 0; k < 4; ++k) {
    const int column = k / 2 + k % 2 * 2;
    out.c[column] = _mm512_shuffle_f64x2(four[k], four[k + 4], 0x88);
    out.c[column + 4] = _mm512_shuffle_f64x2(four[k], four[k + 4], 0xdd);
  }
  return out;
}
template <>
[[gnu::always_inline]] inline void store_quads(Pack<float> a, Pack<float> b, Pack<float> c,
                                               Pack<float> d, float* out) {
  const __m512d ab0 = _mm512_castps_pd(_mm512_unpacklo_ps(a, b)),
                ab1 = _mm512_castps_pd(_mm512_unpackhi_ps(a, b)),
                cd0 = _mm512_castps_pd(_mm512_unpacklo_ps(c, d)),
                cd1 = _mm512_castps_pd(_mm512_unpackhi_ps(c, d));
  _mm512_store_ps(out, _mm512_castpd_ps(_mm512_unpacklo_pd(ab0, cd0)));
  _mm512_store_ps(out + 16, _mm512_castpd_ps(_mm512_unpackhi_pd(ab0, cd0)));
  _mm512_store_ps(out + 32, _mm512_castpd_ps(_mm512_unpacklo_pd(ab1, cd1)));
  _mm512_store_ps(out + 48, _mm512_castpd_ps(_mm512_unpackhi_pd(ab1, cd1)));
}
template <>
[[gnu::always_inline]] inline void store_quads(Pack<double> a, Pack<double> b, Pack<double> c,
                                               Pack<double> d, double* out) {
  const __m512i first = _mm512_setr_epi64(0, 1, 8, 9, 2, 3, 10, 11),
                second = _mm512_setr_epi64(4, 5, 12, 13, 6, 7, 14, 15);
  const __m512d ab0 = _mm512_unpacklo_pd(a, b), ab1 = _mm512_unpackhi_pd(a, b),
                cd0 = _mm512_unpacklo_pd(c, d), cd1 = _mm512_unpackhi_pd(c, d);
  _mm512_store_pd(out, _mm512_permutex2var_pd(ab0, first, cd0));
  _mm512_store_pd(out + 8, _mm512_permutex2var_pd(ab0, second, cd0));
  _mm512_store_pd(out + 16, _mm512_permutex2var_pd(ab1, first, cd1));
  _mm512_store_pd(out + 24, _mm512_permutex2var_pd(ab1, second, cd1));
}
#endif

/// The number of Pack<double> that hold the lanes of one Pack<T>.
template <class T>
inline constexpr std::size_t parts = sizeof(double) / sizeof(T);

/// Part p of a pack, in double precision.
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

/// The places of rows of `numbers` numbers that lie one after another in memory.
template <class T, std::size_t numbers>
inline constexpr auto rising = [] {
  std::array<std::uint16_t, lanes<T>> place{};
  for (std::size_t l = 0; l < place.size(); ++l)
    place[l] = static_cast<std::uint16_t>(l * numbers / 8 * row_units<T>);
  return place;
}();

/// Sums the lanes of each pack: out[k] = sum over the lanes of in[k], always in the same order.
/// `out` needs room for a multiple of 16.
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
/// Sums sixteen packs at a time: a transposition that adds pairs of lanes.
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
/// Sums eight packs at a time.
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
