#include "campaign/process/environment.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>

namespace eerie::process {
namespace {

std::string_view name_of(std::string_view variable) {
  return variable.substr(0, variable.find('='));
}

template <std::size_t N>
bool is_one_of(std::string_view variable, const std::array<std::string_view, N>& names) {
  return std::ranges::find(names, name_of(variable)) != names.end();
}

template <class Unwanted>
Environment environment_without(Unwanted unwanted) {
  Environment all;
  for (char** entry = environ; *entry != nullptr; ++entry)
    if (unwanted(*entry))
      all.left_out.emplace_back(name_of(*entry));
    else
      all.passed_on.push_back(*entry);
  all.passed_on.push_back(nullptr);
  return all;
}

}  // namespace

bool steers_openmp(std::string_view variable) {
  constexpr std::array<std::string_view, 2> how_threads_wait = {"OMP_WAIT_POLICY",
                                                                "GOMP_SPINCOUNT"};
  return (variable.starts_with("OMP_") || variable.starts_with("GOMP_")) &&
         !is_one_of(variable, how_threads_wait);
}

bool steers_slurm(std::string_view variable) {
  constexpr std::array<std::string_view, 4> who_and_where = {"SLURM_CONF", "SLURM_CONF_SERVER",
                                                             "SLURM_JWT", "SLURM_DEBUG"};
  for (const std::string_view start : {"SBATCH_", "SQUEUE_", "SCANCEL_", "SLURM_"})
    if (variable.starts_with(start)) return !is_one_of(variable, who_and_where);
  return false;
}

Environment environment_for_workers() { return environment_without(steers_openmp); }

Environment environment_for_slurm() {
  return environment_without(
      [](std::string_view variable) { return steers_openmp(variable) || steers_slurm(variable); });
}

}  // namespace eerie::process
