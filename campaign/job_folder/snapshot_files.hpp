#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace eerie::job_folder {

/// One snapshot of a run.
struct SnapshotFile {
  std::filesystem::path path;
  double time = 0;  ///< s
};

/// The files snapshot_NNNN.hdf5 and final.hdf5 of a folder, in order of time. Where two have the
/// same time, the first one counts. It reads only their times. Throws InputError where the folder
/// has none.
std::vector<SnapshotFile> snapshot_files(const std::filesystem::path& folder);

/// The index of the snapshot nearest to each time, s. Throws InputError where the nearest one is
/// further away than half of output.snapshot_interval_s and 2 % of the last time. The message lists
/// the times and says how to write more snapshots.
std::vector<std::size_t> nearest(const std::vector<SnapshotFile>& series,
                                 const std::vector<double>& times);

/// The times in words: "0, 500, 1000 ... 50000 s (101 snapshots)".
std::string times_text(const std::vector<SnapshotFile>& series);

}  // namespace eerie::job_folder
