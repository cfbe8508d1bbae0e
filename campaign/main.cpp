#include <string_view>

#include "campaign/cli/cli.hpp"
#include "campaign/process/cpu.hpp"
#include "campaign/process/openmp.hpp"
#include "campaign/process/unread_stderr.hpp"

#ifdef __AVX2__
constexpr bool avx2 = true;
#else
constexpr bool avx2 = false;
#endif
#ifdef __FMA__
constexpr bool fma = true;
#else
constexpr bool fma = false;
#endif
#ifdef __AVX512F__
constexpr bool avx512f = true;
#else
constexpr bool avx512f = false;
#endif
#ifdef __AVX512VBMI2__
constexpr bool avx512vbmi2 = true;
#else
constexpr bool avx512vbmi2 = false;
#endif

/// All others compute in their own threads, bound or not as the user says.
bool starts_workers(std::string_view command) {
  return command == "run" || command == "daemon" || command == "converge" || command == "chart";
}

int main(int argc, char** argv) {
  eerie::process::require_cpu(avx2, fma, avx512f, avx512vbmi2);
  eerie::process::prepare_openmp(argv, argc > 1 && starts_workers(argv[1]));
  eerie::process::let_stderr_go_unread();
  return eerie::cli::main(argc, argv);
}
