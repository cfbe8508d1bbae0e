#pragma once

#include <filesystem>
#include <string>

#include "campaign/job_folder/job_directory.hpp"
#include "db/jobs/rows.hpp"
#include "db/store/connection.hpp"

namespace eerie::cli {

/// The job whose hash begins with `word`. Throws InputError where there is none, or several.
db::Job find_job(const db::Connection& connection, const std::string& word);

/// Whether a word that names a job is a folder, such as `eerie solve --out` makes.
bool is_folder(const std::string& word);

/// The job directory of the job whose hash begins with `word`, or the folder that it names.
job_folder::JobDirectory folder_of(const std::filesystem::path& database, const std::string& word);

}  // namespace eerie::cli
