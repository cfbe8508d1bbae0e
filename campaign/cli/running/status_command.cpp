#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/output/progress_line.hpp"
#include "campaign/cli/output/text_table.hpp"
#include "campaign/job_folder/job_directory.hpp"
#include "campaign/manager/silence.hpp"
#include "campaign/manager/status_file.hpp"
#include "campaign/process/signals.hpp"
#include "db/jobs/jobs.hpp"
#include "db/store/lock.hpp"
#include "db/views/query.hpp"
#include "solver/base/error.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

struct StatusArguments {
  fs::path database;
  bool watch = false, json = false;
};

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
  object["jobs"]["paused"] = sweep.paused;
  object["jobs"]["stale"] = sweep.stale;
  const auto hours = core_hours_left(sweep, speed);
  object["core_hours_left"] = hours ? json(*hours) : json();
  return object;
}

/// What there is to say of a database at one moment.
struct Look {
  std::vector<db::SweepStatus> sweeps;
  std::vector<db::FailureGroup> failures;
  db::Speed speed;
  std::optional<std::string> holder;
  std::optional<manager::CampaignView> at_work;  ///< as the manager says
  std::vector<manager::Silence> silent;
  job_folder::JobFolder folder;
  std::optional<std::string> no_room = {};  ///< asked here: a manager on a full disk cannot say it
};

Look look_at(const fs::path& database) {
  const db::Connection connection(database, db::Access::read);
  Look look{db::sweep_status(connection),
            db::failures(connection),
            db::speed(connection),
            db::lock_holder(database),
            std::nullopt,
            {},
            job_folder::job_folder(connection)};
  if (look.holder) {
    look.at_work = manager::read_status_file(database);
    look.silent = manager::silent_jobs(connection, look.folder);
    constexpr std::uintmax_t little = 1 << 20;
    look.no_room =
        manager::DiskGuard({fs::absolute(database).parent_path(), look.folder.root}, little)
            .complaint(manager::DiskGuard::Clock::now());
  }
  return look;
}

json to_json(const Look& look, const fs::path& database) {
  json report = {
      {"database", database.string()}, {"worked_on_by", look.holder ? json(*look.holder) : json()},
      {"sweeps", json::array()},       {"failures", json::array()},
      {"silent", json::array()},       {"no_room", look.no_room ? json(*look.no_room) : json()}};
  if (look.at_work)
    report["at_work"] = {{"running", look.at_work->running},
                         {"particle_steps_per_s", look.at_work->particle_steps_per_s},
                         {"eta_s", look.at_work->eta_s},
                         {"waiting_for", look.at_work->waiting_for}};
  for (const auto& sweep : look.sweeps) report["sweeps"].push_back(sweep_json(sweep, look.speed));
  for (const auto& f : look.failures)
    report["failures"].push_back({{"kind", f.kind},
                                  {"jobs", f.jobs},
                                  {"hash", f.example_hash},
                                  {"message", f.example_message}});
  for (const manager::Silence& s : look.silent)
    report["silent"].push_back({{"hash", s.hash}, {"host", s.host}, {"seconds", s.seconds}});
  return report;
}

std::string table_of(const Look& look) {
  std::vector<std::vector<std::string>> rows = {{"sweep"}};
  for (const auto name : db::job_state_names) rows[0].emplace_back(name);
  for (const char* name : {"paused", "stale", "core-hours left"}) rows[0].emplace_back(name);
  for (const auto& sweep : look.sweeps) {
    rows.push_back({sweep.name});
    for (std::size_t i = 0; i < db::job_state_names.size(); ++i)
      rows.back().push_back(fmt::format("{}", count(sweep, static_cast<db::JobState>(i))));
    rows.back().push_back(fmt::format("{}", sweep.paused));
    rows.back().push_back(fmt::format("{}", sweep.stale));
    const auto hours = core_hours_left(sweep, look.speed);
    rows.back().push_back(hours ? fmt::format("{:.3g}", *hours) : "-");
  }
  return text_table(rows);
}

std::string text_of(const Look& look, const fs::path& database) {
  std::string text =
      fmt::format("{}: {}\n", database.string(),
                  look.holder ? "worked on by " + *look.holder : "nobody works on it");
  if (look.at_work) text += progress_tail(*look.at_work) + "\n";
  if (look.no_room && (!look.at_work || look.at_work->waiting_for.empty()))
    text += "waiting: " + *look.no_room + "\n";
  text += "\n" + table_of(look);
  for (const auto& f : look.failures)
    text += fmt::format("\nfailed: {} x {}; for example {}: {}\n", f.jobs, f.kind,
                        look.folder.of(f.example_hash).path.string(), f.example_message);
  for (const manager::Silence& s : look.silent)
    text += fmt::format("\nsilent: job {} on {} gave no sign of life for {}; `eerie log {}`\n",
                        s.hash.substr(0, 16), s.host, duration(s.seconds), s.hash.substr(0, 8));
  return text;
}

int watch(const fs::path& database) {
  process::catch_stop_signals();
  process::hold_signals();
  const bool terminal = ::isatty(STDOUT_FILENO) != 0;
  while (process::stop_requests() == 0) {
    const std::string text = text_of(look_at(database), database);
    fmt::print("{}{}{}", terminal ? "\033[H\033[J" : "", text, terminal ? "" : "\n");
    std::fflush(stdout);
    process::wait_for_signal(std::chrono::seconds(2));
  }
  return static_cast<int>(ExitCode::done);
}

int status(const StatusArguments& a) {
  if (a.watch && a.json) throw InputError("--watch --json: give one of them");
  if (a.watch) return watch(a.database);
  const Look look = look_at(a.database);
  if (a.json)
    fmt::print("{}\n", to_json(look, a.database).dump(1));
  else
    fmt::print("{}", text_of(look, a.database));
  return static_cast<int>(ExitCode::done);
}

}  // namespace

Action add_status(CLI::App& app) {
  auto a = std::make_shared<StatusArguments>();
  add_database(app, a->database);
  app.add_flag("--watch", a->watch, "show it anew every two seconds, until Ctrl-C");
  add_json(app, a->json);
  return [a] { return status(*a); };
}

}  // namespace eerie::cli
