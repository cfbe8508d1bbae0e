#include "campaign/cli/options/find_job.hpp"

#include <fmt/format.h>

#include "campaign/cli/options/options.hpp"
#include "db/jobs/jobs.hpp"
#include "solver/base/error.hpp"

namespace eerie::cli {

db::Job find_job(const db::Connection& connection, const std::string& word) {
  SelectionArguments one;
  one.jobs = {word};
  const auto found = db::jobs(connection, {.selection = selection_of(one, "show")});
  if (found.empty())
    throw InputError(fmt::format("JOB = {}: no job of {} has such a hash; `eerie query` shows them",
                                 word, connection.path().string()));
  if (found.size() > 1)
    throw InputError(
        fmt::format("JOB = {}: {} jobs begin so, {} and {} among them; give more digits", word,
                    found.size(), found[0].hash.substr(0, 16), found[1].hash.substr(0, 16)));
  return found.front();
}

bool is_folder(const std::string& word) {
  std::error_code ignored;
  return std::filesystem::is_directory(word, ignored);
}

job_folder::JobDirectory folder_of(const std::filesystem::path& database, const std::string& word) {
  if (is_folder(word)) return {word};
  const db::Connection connection(database, db::Access::read);
  return job_folder::job_folder(connection).of(find_job(connection, word).hash);
}

}  // namespace eerie::cli
