#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "campaign/cli/commands.hpp"
#include "campaign/cli/text_table.hpp"
#include "campaign/job_directory.hpp"
#include "db/lock.hpp"
#include "db/query.hpp"
#include "solver/base/error.hpp"

namespace eerie::cli {
using nlohmann::json;

namespace {

std::int64_t count(const db::SweepStatus& sweep, db::JobState state) {
  const auto entry = sweep.jobs.find(state);
  return entry == sweep.jobs.end() ? 0 : entry->second;
}

/// Core-hours that a sweep still needs at the measured speed; nothing while none is measured.
std::optional<double> core_hours_left(const db::SweepStatus& sweep, const db::Speed& speed) {
  if (!speed.is_measured()) return std::nullopt;
  return speed.core_seconds_of(sweep.particle_steps_left) / 3600;
}

json sweep_json(const db::SweepStatus& sweep, const db::Speed& speed) {
  json object = {{"name", sweep.name}, {"created", sweep.created}};
  for (std::size_t i = 0; i < db::job_state_names.size(); ++i)
    object["jobs"][std::string(db::job_state_names[i])] =
        count(sweep, static_cast<db::JobState>(i));
  const auto hours = core_hours_left(sweep, speed);
  object["core_hours_left"] = hours ? json(*hours) : json();
  return object;
}

}  // namespace

int status(const StatusArguments& a) {
  const db::Connection connection(a.database, db::Access::read);
  const auto sweeps = db::sweep_status(connection);
  const auto failures = db::failures(connection);
  const db::Speed speed = db::speed(connection);
  const auto holder = db::lock_holder(a.database);
  if (a.json) {
    json report = {{"database", a.database.string()},
                   {"worked_on_by", holder ? json(*holder) : json()},
                   {"sweeps", json::array()},
                   {"failures", json::array()}};
    for (const auto& sweep : sweeps) report["sweeps"].push_back(sweep_json(sweep, speed));
    for (const auto& f : failures)
      report["failures"].push_back({{"kind", f.kind},
                                    {"jobs", f.jobs},
                                    {"hash", f.example_hash},
                                    {"message", f.example_message}});
    fmt::print("{}\n", report.dump(1));
    return static_cast<int>(ExitCode::done);
  }
  std::vector<std::vector<std::string>> rows = {{"sweep"}};
  for (const auto name : db::job_state_names) rows[0].emplace_back(name);
  rows[0].emplace_back("core-hours left");
  for (const auto& sweep : sweeps) {
    rows.push_back({sweep.name});
    for (std::size_t i = 0; i < db::job_state_names.size(); ++i)
      rows.back().push_back(fmt::format("{}", count(sweep, static_cast<db::JobState>(i))));
    const auto hours = core_hours_left(sweep, speed);
    rows.back().push_back(hours ? fmt::format("{:.3g}", *hours) : "-");
  }
  fmt::print("{}: {}\n\n{}", a.database.string(),
             holder ? "worked on by " + *holder : "nobody works on it", text_table(rows));
  for (const auto& f : failures)
    fmt::print("\nfailed: {} x {}; for example {}: {}\n", f.jobs, f.kind,
               job_directory(a.database, f.example_hash).path.string(), f.example_message);
  return static_cast<int>(ExitCode::done);
}

}  // namespace eerie::cli
