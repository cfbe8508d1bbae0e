#include "campaign/serve/views/overview.hpp"

#include <nlohmann/json.hpp>

#include "campaign/manager/space_guard.hpp"
#include "campaign/manager/status_file.hpp"
#include "db/jobs/jobs.hpp"
#include "db/jobs/timeline.hpp"
#include "db/store/lock.hpp"

namespace eerie::serve {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

json or_null(const std::optional<std::string>& text) { return text ? json(*text) : json(); }
json or_null(const std::optional<double>& value) { return value ? json(*value) : json(); }

json to_json(const db::SweepStatus& sweep, const db::Speed& speed) {
  json object = {{"name", sweep.label}, {"created", sweep.created}};
  for (std::size_t i = 0; i < db::job_state_names.size(); ++i)
    object["jobs"][std::string(db::job_state_names[i])] =
        count(sweep, static_cast<db::JobState>(i));
  object["jobs"]["paused"] = sweep.paused;
  object["jobs"]["stale"] = sweep.stale;
  object["core_hours_left"] = or_null(core_hours_left(sweep, speed));
  return object;
}

json to_json(const manager::CampaignView& at_work) {
  return {{"running", at_work.running},
          {"particle_steps_per_s", at_work.particle_steps_per_s},
          {"eta_s", at_work.eta_s},
          {"stopping", at_work.stopping},
          {"waiting_for", at_work.waiting_for}};
}

}  // namespace

Overview overview_of(const db::Connection& connection) {
  const fs::path& database = connection.path();
  Overview o{db::sweep_status(connection),
             db::failures(connection),
             db::speed(connection),
             db::lock_holder(database),
             std::nullopt,
             {},
             job_folder::job_folder(connection)};
  if (o.holder) {
    o.at_work = manager::read_status_file(database);
    o.silent = manager::silent_jobs(connection, o.folder);
    constexpr std::uintmax_t little = 1 << 20;
    o.no_room = manager::SpaceGuard({fs::absolute(database).parent_path(), o.folder.root}, little)
                    .complaint(manager::SpaceGuard::Clock::now());
  }
  return o;
}

std::int64_t count(const db::SweepStatus& sweep, db::JobState state) {
  const auto entry = sweep.jobs.find(state);
  return entry == sweep.jobs.end() ? 0 : entry->second;
}

std::optional<double> core_hours_left(const db::SweepStatus& sweep, const db::Speed& speed) {
  if (!speed.is_measured()) return std::nullopt;
  return speed.core_seconds_of(sweep.particle_steps_left) / 3600;
}

json to_json(const Overview& o, const fs::path& database) {
  json report = {{"database", database.string()}, {"worked_on_by", or_null(o.holder)},
                 {"sweeps", json::array()},       {"failures", json::array()},
                 {"silent", json::array()},       {"no_room", or_null(o.no_room)}};
  if (o.at_work) report["at_work"] = to_json(*o.at_work);
  for (const auto& sweep : o.sweeps) report["sweeps"].push_back(to_json(sweep, o.speed));
  for (const auto& f : o.failures)
    report["failures"].push_back({{"kind", f.kind},
                                  {"jobs", f.jobs},
                                  {"hash", f.example_hash},
                                  {"message", f.example_message}});
  for (const manager::Silence& s : o.silent)
    report["silent"].push_back({{"hash", s.hash}, {"host", s.host}, {"seconds", s.seconds}});
  return report;
}

json work_json(const fs::path& database) {
  const auto holder = db::lock_holder(database);
  const auto at_work = holder ? manager::read_status_file(database) : std::nullopt;
  return {{"worked_on_by", or_null(holder)}, {"at_work", at_work ? to_json(*at_work) : json()}};
}

json campaign_json(const db::Connection& connection) {
  const Overview o = overview_of(connection);
  json report = to_json(o, connection.path());
  const db::JobCounts counts = db::count_jobs(connection, std::nullopt);
  for (std::size_t i = 0; i < db::job_state_names.size(); ++i)
    report["jobs"][std::string(db::job_state_names[i])] = counts.in_state.at(i);
  report["jobs"]["paused"] = counts.paused;
  report["jobs"]["total"] = counts.total();
  return report;
}

json timeline_json(const db::Connection& connection) {
  constexpr std::size_t most = 400;
  json spans = json::array();
  for (const db::WorkSpan& s : db::newest_work(connection, most))
    spans.push_back({{"hash", s.hash},
                     {"host", s.host},
                     {"worker", s.worker},
                     {"started", s.started},
                     {"ended", s.ended},
                     {"exit_reason", s.exit_reason},
                     {"failure_kind", s.failure_kind}});
  return {{"spans", std::move(spans)}};
}

}  // namespace eerie::serve
