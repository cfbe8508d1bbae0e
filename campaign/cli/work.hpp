#pragma once

#include <filesystem>

#include "campaign/cli/options/scheduler_options.hpp"
#include "db/store/connection.hpp"

namespace eerie::cli {

inline constexpr int stopped_by_signal = 130;  // 128 + SIGINT, as shells expect

/// How the user wants the cores shared; 0: chosen.
struct Share {
  int workers = 0, threads_per_job = 0;
  bool quiet = false;  ///< does not print the measured split
};

/// Makes the folder of a file that is to be written. Throws EnvironmentError.
void make_folder_of(const std::filesystem::path& file);

/// Runs the pending jobs of a sweep until none is left or a stop is asked for, with a progress
/// line. The caller holds the database's lock.
void work(db::Connection& connection, const Share& share, std::int64_t sweep,
          const EngineArguments& engine = {});

struct Tally {
  std::size_t total = 0, done = 0, failed = 0, left = 0;
  std::size_t paused = 0;  ///< of those left
};
Tally tally(const db::Connection& connection, std::int64_t sweep);

}  // namespace eerie::cli
