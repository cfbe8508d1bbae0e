#pragma once

#include <chrono>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace eerie::slurm {

/// The options of submissions to a cluster. profile.schema.json gives the meaning of each field. An
/// empty text leaves the choice to the cluster.
struct SlurmProfile {
  std::string partition, account, qos, constraint, memory;
  std::optional<std::chrono::seconds> time_limit = {};
  int cpus_per_task = 1;
  std::vector<std::string> extra_sbatch_options = {};
  std::optional<int> max_array_size = {};
  int max_queued = 1000;
  double minutes_per_array_task = 15;
  int signal_before_end_s = 120;
  double poll_interval_s = 10;
  int listed_within_s = 120;
};

/// Reads a profile. Throws InputError, which names field, value, the allowed values and the mend.
SlurmProfile parse_slurm_profile(const nlohmann::json& given, const std::string& where);
SlurmProfile load_slurm_profile(const std::filesystem::path& path);

/// The seconds of a time limit in a form of sbatch ("90", "90:00", "1:30:00", "2-12", "2-12:30",
/// "2-12:30:00"); nothing for other texts.
std::optional<std::chrono::seconds> parse_time_limit(const std::string& text);

}  // namespace eerie::slurm
