#include "campaign/process/openmp.hpp"

#include <omp.h>
#include <sched.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace eerie::process {
namespace {

/// Rounds of waiting before a thread sleeps. docs/decisions.md has the measurement.
constexpr const char* rounds_before_sleep = "1000";

constexpr const char* binding_variables[] = {"OMP_PROC_BIND", "OMP_PLACES", "GOMP_CPU_AFFINITY"};

bool is_set(const char* variable) { return std::getenv(variable) != nullptr; }

/// The cores of all of OpenMP's places, on one of which it has put this thread.
void run_on_all_places() {
  cpu_set_t all;
  CPU_ZERO(&all);
  for (int place = 0; place < omp_get_num_places(); ++place) {
    std::vector<int> cores(static_cast<std::size_t>(omp_get_place_num_procs(place)));
    omp_get_place_proc_ids(place, cores.data());
    for (const int core : cores) CPU_SET(core, &all);
  }
  if (CPU_COUNT(&all) > 0) ::sched_setaffinity(0, sizeof all, &all);
}

/// Returns whether anything was bound.
bool unbind() {
  if (omp_get_proc_bind() == omp_proc_bind_false) return false;
  std::string names;
  for (const char* variable : binding_variables) {
    if (!is_set(variable)) continue;
    names += (names.empty() ? "" : ", ") + std::string(variable);
    ::unsetenv(variable);
  }
  if (names.empty()) return false;
  run_on_all_places();
  std::fprintf(stderr, "%s: not used, since all workers would share the first core\n",
               names.c_str());
  return true;
}

/// By its own name where it still has one: that is what `ps` and `top` then show.
void start_again(char** arguments) {
  std::error_code ignored;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", ignored);
  if (!program.empty()) ::execv(program.c_str(), arguments);
  ::execv("/proc/self/exe", arguments);
}

}  // namespace

void prepare_openmp(char** arguments, bool starts_workers) {
  bool changed = starts_workers && unbind();
  if (!is_set("OMP_WAIT_POLICY") && !is_set("GOMP_SPINCOUNT"))
    changed |= ::setenv("GOMP_SPINCOUNT", rounds_before_sleep, 0) == 0;
  if (changed) start_again(arguments);
  // Where that is not possible, the program works as it is, only slower.
}

}  // namespace eerie::process
