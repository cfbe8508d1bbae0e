#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#if defined(__AVX512F__)
#include <immintrin.h>
#endif

/// This is the one folder that knows vector registers. Physics is written once, on Pack<T>, with
/// plain operators. This file adds the width and the few functions that operators lack. Results
/// depend on the compiled width and never on the thread.
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
