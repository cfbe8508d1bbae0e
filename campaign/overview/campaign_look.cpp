#include "campaign/overview/campaign_look.hpp"

#include <nlohmann/json.hpp>

#include "campaign/manager/space_guard.hpp"
#include "campaign/manager/status_file.hpp"
#include "db/store/lock.hpp"

namespace eerie::overview {
using nlohmann::json;
using text::or_null, text::shown;

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
  json object = {{"name", sweep.name}, {"label", sweep.label}, {"created", sweep.created}};
  for (std::size_t i = 0; i < db::job_state_names.size(); ++i)
    object["jobs"][std::string(db::job_state_names[i])] =
        count(sweep, static_cast<db::JobState>(i));
  object["jobs"]["paused"] = sweep.paused;
  object["jobs"]["stale"] = sweep.stale;
  object["core_hours_left"] = or_null(core_hours_left(sweep, speed));
  return object;
}

}  // namespace

CampaignLook look_at(const std::filesystem::path& database) {
  const db::Connection connection(database, db::Access::read);
  CampaignLook look{db::sweep_status(connection),
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
        manager::SpaceGuard({std::filesystem::absolute(database).parent_path(), look.folder.root},
                            little)
            .complaint(manager::SpaceGuard::Clock::now());
  }
  return look;
}

json to_json(const std::vector<db::FailureGroup>& failures) {
  json list = json::array();
  for (const db::FailureGroup& f : failures)
    list.push_back({{"kind", f.kind},
                    {"jobs", f.jobs},
                    {"hash", f.example_hash},
                    {"message", f.example_message}});
  return list;
}

json to_json(const CampaignLook& look, const std::filesystem::path& database) {
  json report = {{"database", database.string()}, {"worked_on_by", or_null(look.holder)},
                 {"sweeps", json::array()},       {"failures", to_json(look.failures)},
                 {"silent", json::array()},       {"no_room", or_null(look.no_room)}};
  if (look.at_work)
    report["at_work"] = {{"running", look.at_work->running},
                         {"particle_steps_per_s", look.at_work->particle_steps_per_s},
                         {"eta_s", look.at_work->eta_s},
                         {"waiting_for", look.at_work->waiting_for}};
  for (const auto& sweep : look.sweeps) report["sweeps"].push_back(sweep_json(sweep, look.speed));
  for (const manager::Silence& s : look.silent)
    report["silent"].push_back({{"hash", s.hash}, {"host", s.host}, {"seconds", s.seconds}});
  return report;
}

text::Table table_of_sweeps(const CampaignLook& look) {
  using db::SweepStatus;
  std::vector<text::Field<SweepStatus>> fields = {
      {shown("sweep"), [](const SweepStatus& s) { return s.label; }}};
  for (std::size_t i = 0; i < db::job_state_names.size(); ++i)
    fields.push_back({shown(std::string(db::job_state_names[i])), [i](const SweepStatus& s) {
                        return count(s, static_cast<db::JobState>(i));
                      }});
  fields.push_back({shown("paused"), [](const SweepStatus& s) { return s.paused; }});
  fields.push_back({shown("stale"), [](const SweepStatus& s) { return s.stale; }});
  fields.push_back({shown("core-hours left", "{:.3g}"),
                    [&](const SweepStatus& s) { return or_null(core_hours_left(s, look.speed)); }});
  return text::table_of(fields, look.sweeps);
}

}  // namespace eerie::overview
