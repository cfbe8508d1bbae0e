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

/// snapshot_NNNN.hdf5 and final.hdf5 of a folder in order of time; where two are of one time, the
/// first. Only their times are read. Throws InputError where the folder holds none.
std::vector<SnapshotFile> snapshot_files(const std::filesystem::path& folder);

/// Index of the snapshot nearest each time, s. Throws InputError with the times that there are and
/// how to have more written, where the nearest is farther away than half of
/// output.snapshot_interval_s and 2 % of the last time.
std::vector<std::size_t> nearest(const std::vector<SnapshotFile>& series,
                                 const std::vector<double>& times);

/// Five moments that tell the story of an impact, or as many as there are: the snapshots nearest 0,
/// 5, 15, 40 and 100 % of the time covered.
std::vector<std::size_t> telling(const std::vector<SnapshotFile>& series);

/// "0, 500, 1000 ... 50000 s (101 snapshots)"
std::string times_text(const std::vector<SnapshotFile>& series);

}  // namespace eerie::job_folder
