#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace eerie::process {

/// Whether a variable ("NAME=value") steers OpenMP's threads but for how they wait. Written for one
/// program that has the machine to itself, such settings are wrong for several workers: bound
/// threads of all of them share the first cores. Workers are told their number of threads.
bool steers_openmp(std::string_view variable);

/// Whether it changes what Slurm's commands do or tell: SBATCH_*, SQUEUE_*, SCANCEL_*, and SLURM_*
/// but for where the cluster is and who we are (SLURM_CONF, SLURM_JWT).
bool steers_slurm(std::string_view variable);

/// This process's environment as a program that we start gets it, in parts.
struct Environment {
  std::vector<char*> passed_on;       ///< ends with a null pointer, as exec wants it
  std::vector<std::string> left_out;  ///< names
};

Environment environment_for_workers();
Environment environment_for_slurm();

}  // namespace eerie::process
