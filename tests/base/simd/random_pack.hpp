#pragma once

#include "solver/base/random.hpp"
#include "solver/base/simd/pack.hpp"

namespace eerie::test {

template <class T>
Pack<T> random_pack(Random& random, double lo, double hi) {
  Pack<T> p;
  for (int l = 0; l < lanes<T>; ++l) p[l] = static_cast<T>(random.uniform(lo, hi));
  return p;
}

}  // namespace eerie::test
