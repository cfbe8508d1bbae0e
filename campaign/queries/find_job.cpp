#include "campaign/queries/find_job.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "campaign/job_folder/snapshot_files.hpp"
#include "campaign/queries/numbers.hpp"
#include "db/jobs/jobs.hpp"
#include "solver/base/error.hpp"
#include "solver/base/text/shell_word.hpp"

namespace eerie::queries {
namespace {

/// A job is named by its hash or the first digits of it.
void require_hash(const std::string& word) {
  constexpr std::size_t fewest = 4, most = 64;
  const bool hexadecimal = std::ranges::all_of(
      word, [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
  if (!hexadecimal || word.size() < fewest || word.size() > most)
    throw InputError(
        fmt::format("JOB = {}: must be the first {} or more digits of a job's hash (0-9, a-f), as "
                    "`eerie query` "
                    "and `eerie expand --list` show them; for example 3f9a20c1",
                    word, fewest));
}

}  // namespace

db::Selection selection_of(const JobChoice& a, const std::string& command) {
  for (const std::string& word : a.jobs) require_hash(word);
  db::Selection s{a.sweep, a.jobs, a.q, a.phi_d_deg, {}, {}};
  if (!a.v.empty()) s.v_imp_cm_per_s = parse_range(a.v, "--v");
  if (!a.theta.empty()) s.theta_imp_deg = parse_range(a.theta, "--theta");
  if (s.is_everything() && !a.all)
    throw InputError(fmt::format(
        "`eerie {}` needs to know which jobs: name them, or give --sweep, --q, --phi-d, --v or "
        "--theta; --all means every job",
        command));
  return s;
}

db::Job find_job(const db::Connection& connection, const std::string& word) {
  JobChoice one;
  one.jobs = {word};
  const auto found = db::jobs(connection, {.selection = selection_of(one, "show")});
  if (found.empty())
    throw InputError(
        fmt::format("JOB = {}: no job of {} has such a hash; `eerie query --db {} "
                    "--columns hash` shows those with results",
                    word, connection.path().string(), shell_word(connection.path().string())));
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

std::filesystem::path snapshot_of(const std::filesystem::path& database, const std::string& word) {
  if (std::filesystem::path(word).extension() == ".hdf5") return word;
  return job_folder::snapshot_files(folder_of(database, word).path).back().path;
}

}  // namespace eerie::queries
