#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "db/jobs/merge.hpp"

namespace eerie::merging {

struct MergeOptions {
  /// Copies the job directories of the sources, so that these may be removed. Otherwise symbolic
  /// links lead to them.
  bool copies_files = false;
};

/// What became of one source.
struct SourceReport {
  std::filesystem::path database;
  db::Merged merged;
  std::size_t files = 0;    ///< job directories that were linked or copied
  std::size_t missing = 0;  ///< jobs whose directories are not there (any more)
};

/// Puts the databases `sources` into `target`, in one transaction: a process that is killed leaves
/// the target as it was. Job directories appear in the target's job folder before the transaction
/// ends, so that the next attempt finds them. Holds the lock of the target: throws db::LockedError
/// while a manager works on it. Throws InputError where a database is given twice, and db::Error
/// where one is missing or has an older schema.
std::vector<SourceReport> merge_into(const std::filesystem::path& target,
                                     const std::vector<std::filesystem::path>& sources,
                                     const MergeOptions& options);

/// Puts `sources` into a database that is made for them, and appears whole or not at all; the
/// sources stay as they are. Throws InputError where `target` exists.
std::vector<SourceReport> merge_as(const std::filesystem::path& target,
                                   const std::vector<std::filesystem::path>& sources,
                                   const MergeOptions& options);

}  // namespace eerie::merging
