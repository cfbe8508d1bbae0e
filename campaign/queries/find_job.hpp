#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "campaign/job_folder/job_directory.hpp"
#include "db/jobs/rows.hpp"
#include "db/jobs/selection.hpp"
#include "db/store/connection.hpp"

namespace eerie::queries {

/// A choice of jobs by their hashes, their sweep and their points.
struct JobChoice {
  std::vector<std::string> jobs;
  std::optional<std::string> sweep;
  std::optional<double> q, phi_d_deg;
  std::string v, theta;  ///< "LO:HI" or one number; empty: all
  bool all = false;
};
/// The selection of a choice. Throws InputError for a word that is no hash, and where a choice
/// without conditions lacks --all.
db::Selection selection_of(const JobChoice& choice, const std::string& command);

/// The job whose hash begins with `word`. Throws InputError where there is none, or several.
db::Job find_job(const db::Connection& connection, const std::string& word);

/// Whether a word is a folder, such as `eerie solve --out` makes, and no hash.
bool is_folder(const std::string& word);

/// The directory of the job whose hash begins with `word`, or the folder of that name.
job_folder::JobDirectory folder_of(const std::filesystem::path& database, const std::string& word);

/// The snapshot that `word` names: a file (.hdf5), or the last snapshot of folder_of(). Throws
/// InputError where there is none.
std::filesystem::path snapshot_of(const std::filesystem::path& database, const std::string& word);

}  // namespace eerie::queries
