#pragma once

#include <cstddef>

#include "solver/base/simd/pack.hpp"
#include "solver/base/tensor.hpp"

namespace eerie {

// These functions move the numbers of several particles from arrays of structures into packs and
// back. `count` of the lanes are particles; the other lanes read zero and are not written.

using DoublePack = Pack<double>;

/// Makes a pack whose lane l is value(l).
template <class Value>
[[gnu::always_inline]] inline DoublePack gathered(std::size_t count, Value&& value) {
  DoublePack pack{};
  if (count == lanes<double>)
    for (std::size_t l = 0; l < lanes<double>; ++l) pack[l] = value(l);
  else
    for (std::size_t l = 0; l < count; ++l) pack[l] = value(l);
  return pack;
}

/// Calls put(l, lane l) for each of the lanes.
template <class Put>
[[gnu::always_inline]] inline void scatter(std::size_t count, DoublePack pack, Put&& put) {
  if (count == lanes<double>)
    for (std::size_t l = 0; l < lanes<double>; ++l) put(l, pack[l]);
  else
    for (std::size_t l = 0; l < count; ++l) put(l, pack[l]);
}

inline SymTensorOf<DoublePack> gathered_tensors(std::size_t count, const SymTensor* s) {
  const auto of = [&](auto component) __attribute__((always_inline)) {
    return gathered(count, [&](std::size_t l) { return s[l].*component; });
  };
  return {of(&SymTensor::xx), of(&SymTensor::yy), of(&SymTensor::zz),
          of(&SymTensor::xy), of(&SymTensor::xz), of(&SymTensor::yz)};
}

template <class T>
inline void scatter_tensors(std::size_t count, const SymTensorOf<DoublePack>& packs,
                            SymTensorOf<T>* s) {
  using Tensor = SymTensorOf<T>;
  const auto put = [&](auto component, DoublePack pack) __attribute__((always_inline)) {
    scatter(count, pack,
            [&](std::size_t l, double value) { s[l].*component = static_cast<T>(value); });
  };
  put(&Tensor::xx, packs.xx), put(&Tensor::yy, packs.yy), put(&Tensor::zz, packs.zz);
  put(&Tensor::xy, packs.xy), put(&Tensor::xz, packs.xz), put(&Tensor::yz, packs.yz);
}

}  // namespace eerie
