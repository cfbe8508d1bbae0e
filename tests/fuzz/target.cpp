#include <cstdint>

#include "tests/fuzz/readers.hpp"

/// HDF5 1.10 loses some memory over damaged files.
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5"; }

/// EERIE_FUZZED: the reader under fire, one program for each (CMakeLists.txt).
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  eerie::fuzz::EERIE_FUZZED({reinterpret_cast<const char*>(data), size});
  return 0;
}
