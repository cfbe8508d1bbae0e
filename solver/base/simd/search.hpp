#pragma once

#include "solver/base/simd/pack.hpp"

// Which lanes are near: keeping them, side by side and in order.

namespace eerie {

/// Bit l says whether p[l] < limit.
template <class T>
inline std::uint32_t lanes_below(Pack<T> p, T limit) {
#if defined(__AVX512F__)
  if constexpr (sizeof(T) == 4)
    return _mm512_cmp_ps_mask(p, _mm512_set1_ps(limit), _CMP_LT_OQ);
  else
    return _mm512_cmp_pd_mask(p, _mm512_set1_pd(limit), _CMP_LT_OQ);
#else
  std::uint32_t below = 0;
  for (int l = 0; l < lanes<T>; ++l) below |= std::uint32_t{p[l] < limit} << l;
  return below;
#endif
}

/// Writes ids[l] to `out` for every lane l with p[l] < limit, in order; returns the end. `out` has
/// room for a whole pack.
inline std::uint16_t* append_less(Pack<float> p, float limit, const std::uint16_t* ids,
                                  std::uint16_t* out) {
#if defined(__AVX512VBMI2__) && defined(__AVX512VL__)
  const auto near = static_cast<__mmask16>(lanes_below(p, limit));
  const __m256i kept =
      _mm256_maskz_compress_epi16(near, _mm256_loadu_si256(reinterpret_cast<const __m256i*>(ids)));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(out), kept);
  return out + __builtin_popcount(near);
#else
  for (int l = 0; l < lanes<float>; ++l) {
    *out = ids[l];
    out += p[l] < limit;
  }
  return out;
#endif
}
/// Writes first + l in the same way.
inline std::uint32_t* append_less(Pack<double> p, double limit, std::uint32_t first,
                                  std::uint32_t* out) {
#if defined(__AVX512F__) && defined(__AVX512VL__)
  const auto near = static_cast<__mmask8>(lanes_below(p, limit));
  const __m256i ids = _mm256_add_epi32(_mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7),
                                       _mm256_set1_epi32(static_cast<int>(first)));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(out), _mm256_maskz_compress_epi32(near, ids));
  return out + __builtin_popcount(near);
#else
  for (int l = 0; l < lanes<double>; ++l) {
    *out = first + static_cast<std::uint32_t>(l);
    out += p[l] < limit;
  }
  return out;
#endif
}

/// x, y and z of `count` vectors that lie one after another; further lanes read zero.
struct VectorPacks {
  Pack<double> x, y, z;
};
inline VectorPacks load_vectors(const double* xyz, std::size_t count) {
  VectorPacks out{};
#if defined(__AVX512F__)
  const std::uint32_t there = (1u << 3 * count) - 1;
  const __m512d a = _mm512_maskz_loadu_pd(static_cast<__mmask8>(there), xyz),
                b = _mm512_maskz_loadu_pd(static_cast<__mmask8>(there >> 8), xyz + 8),
                c = _mm512_maskz_loadu_pd(static_cast<__mmask8>(there >> 16), xyz + 16);
  // Numbers 0, 3, 6... of 24: those of a and b first, then those of c into their places.
  const auto every_third = [&](int k) __attribute__((always_inline)) {
    const __m512i two = _mm512_setr_epi64(k, k + 3, k + 6, k + 9, k + 12, (k + 15) % 16, 0, 0);
    const __m512i three = _mm512_setr_epi64(0, 1, 2, 3, 4, k + 15 < 16 ? 5 : k + 7, k + 10, k + 13);
    return _mm512_permutex2var_pd(_mm512_permutex2var_pd(a, two, b), three, c);
  };
  out.x = every_third(0), out.y = every_third(1), out.z = every_third(2);
#else
  for (std::size_t l = 0; l < count; ++l)
    out.x[l] = xyz[3 * l], out.y[l] = xyz[3 * l + 1], out.z[l] = xyz[3 * l + 2];
#endif
  return out;
}

}  // namespace eerie
