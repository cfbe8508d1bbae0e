#include "campaign/process/cpu.hpp"

#include <cstdio>
#include <cstdlib>

// Compiled for any x86-64: nothing here may need what it asks for.

namespace eerie::process {

void require_cpu(bool avx2, bool fma, bool avx512f, bool avx512vbmi2) {
  const char* missing = avx2 && !__builtin_cpu_supports("avx2")                 ? "AVX2"
                        : fma && !__builtin_cpu_supports("fma")                 ? "FMA"
                        : avx512f && !__builtin_cpu_supports("avx512f")         ? "AVX-512F"
                        : avx512vbmi2 && !__builtin_cpu_supports("avx512vbmi2") ? "AVX-512 VBMI2"
                                                                                : nullptr;
  if (missing == nullptr) return;
  std::fprintf(
      stderr,
      "eerie: this program was built for a machine with %s, which this one lacks; build it "
      "here (make clean build), or for any x86-64: cmake -DEERIE_NATIVE=OFF\n",
      missing);
  std::exit(3);
}

}  // namespace eerie::process
