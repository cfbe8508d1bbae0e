#pragma once

#include <array>

#include "solver/base/simd/pack.hpp"

// Loading and adding of scattered rows.

namespace eerie {

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

/// The places of rows of `numbers` numbers that lie one after another in memory.
template <class T, std::size_t numbers>
inline constexpr auto rising = [] {
  std::array<std::uint16_t, lanes<T>> place{};
  for (std::size_t l = 0; l < place.size(); ++l)
    place[l] = static_cast<std::uint16_t>(l * numbers / 8 * row_units<T>);
  return place;
}();

}  // namespace eerie
