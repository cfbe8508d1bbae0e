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

/// Jobs by their hashes, their sweep and their points.
struct JobChoice {
  std::vector<std::string> jobs;
  std::optional<std::string> sweep;
  std::optional<double> q, phi_d_deg;
  std::string v, theta;  ///< "LO:HI" or one number; empty: all
  bool all = false;
};
/// Throws InputError for a word that is no job, and where nothing is selected without --all.
db::Selection selection_of(const JobChoice& choice, const std::string& command);

/// The job whose hash begins with `word`. Throws InputError where there is none, or several.
db::Job find_job(const db::Connection& connection, const std::string& word);

/// Whether a word that names a job is a folder, such as `eerie solve --out` makes.
bool is_folder(const std::string& word);

/// The job directory of the job whose hash begins with `word`, or the folder that it names.
job_folder::JobDirectory folder_of(const std::filesystem::path& database, const std::string& word);

}  // namespace eerie::queries
