#include "campaign/results/job_report.hpp"

#include <algorithm>
#include <filesystem>

#include "campaign/job_folder/job_directory.hpp"
#include "db/jobs/jobs.hpp"
#include "db/views/query.hpp"

namespace eerie::results {
namespace fs = std::filesystem;
using nlohmann::json;
using text::both, text::data, text::or_null, text::shown;
using text::Value;

namespace {

Value or_nothing(const std::string& text) { return text.empty() ? Value() : Value(text); }

/// Files of the job directory with their sizes, in order of their names.
std::vector<std::pair<fs::path, std::uintmax_t>> files_of(
    const job_folder::JobDirectory& directory) {
  std::vector<std::pair<fs::path, std::uintmax_t>> files;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(directory.path, missing))
    if (entry.is_regular_file(missing)) files.emplace_back(entry.path(), entry.file_size(missing));
  std::ranges::sort(files);
  return files;
}

}  // namespace

text::Table table_of_attempts(const std::vector<db::AttemptRow>& rows) {
  using Row = db::AttemptRow;
  return text::table_of<Row>(
      {{both("started", "started"), [](const Row& a) { return a.started; }},
       {both("host", "host"), [](const Row& a) { return a.host; }},
       {both("worker", "worker"), [](const Row& a) { return or_nothing(a.worker); }},
       {data("version"), [](const Row& a) { return a.version; }},
       {both("ended", "ended"), [](const Row& a) { return or_nothing(a.ended); }},
       {both("exit_reason", "because"), [](const Row& a) { return or_nothing(a.exit_reason); }},
       {data("failure_kind"), [](const Row& a) { return or_nothing(a.failure_kind); }},
       {both("core_seconds", "core-s", "{:.1f}"),
        [](const Row& a) { return or_null(a.core_seconds); }},
       {data("particle_steps"), [](const Row& a) { return or_null(a.particle_steps); }},
       {data("peak_memory_bytes"), [](const Row& a) { return or_null(a.peak_memory_bytes); }},
       {shown("peak MB", "{:.1f}"),
        [](const Row& a) {
          return a.peak_memory_bytes ? Value(1e-6 * static_cast<double>(*a.peak_memory_bytes))
                                     : Value();
        }},
       {both("message", "message"), [](const Row& a) { return or_nothing(a.message); }}},
      rows);
}

json job_report(const db::Connection& connection, const db::Job& job) {
  const job_folder::JobDirectory directory = job_folder::job_folder(connection).of(job.hash);
  const auto progress = job_folder::read_progress(directory);
  json report = {{"hash", job.hash},
                 {"state", db::job_state_names.at(static_cast<std::size_t>(job.state))},
                 {"wanted", db::wanted_names.at(static_cast<std::size_t>(job.wanted))},
                 {"priority", job.priority},
                 {"crashes", job.crashes},
                 {"wall_limit_s", or_null(job.wall_limit_s)},
                 {"sweeps", db::sweeps_of(connection, job.id)},
                 {"scene", json::parse(db::scene(connection, job.id))},
                 {"progress", progress ? job_folder::to_json(*progress) : json()},
                 {"result", job_folder::read_json(directory.result()).value_or(json())},
                 {"failure", job_folder::read_json(directory.failure()).value_or(json())},
                 {"attempts", text::records(table_of_attempts(db::attempts(connection, job.id)))},
                 {"directory", directory.path.string()},
                 {"files", json::array()}};
  for (const auto& [path, bytes] : files_of(directory))
    report["files"].push_back({{"path", path.string()}, {"bytes", bytes}});
  return report;
}

}  // namespace eerie::results
