#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "campaign/job_folder/job_directory.hpp"
#include "campaign/manager/manager.hpp"
#include "campaign/manager/silence.hpp"
#include "db/views/query.hpp"

namespace eerie::serve {

/// What there is to say of a database at one moment: `eerie status`, and the first view of the
/// dashboard.
struct Overview {
  std::vector<db::SweepStatus> sweeps;
  std::vector<db::FailureGroup> failures;
  db::Speed speed;
  std::optional<std::string> holder;
  std::optional<manager::CampaignView> at_work;  ///< as the manager says
  std::vector<manager::Silence> silent;
  job_folder::JobFolder folder;
  std::optional<std::string> no_room = {};  ///< asked here: a manager on a full disk cannot say it
};
Overview overview_of(const db::Connection& connection);

std::int64_t count(const db::SweepStatus& sweep, db::JobState state);
/// Core-hours that a sweep still needs at the measured speed; nothing while none is measured.
std::optional<double> core_hours_left(const db::SweepStatus& sweep, const db::Speed& speed);

nlohmann::json to_json(const Overview& overview, const std::filesystem::path& database);

/// Who works on a database, and what the manager says of it: {"worked_on_by", "at_work"}, null
/// where nobody does. Opens no database.
nlohmann::json work_json(const std::filesystem::path& database);

/// to_json() with what the first view shows besides: jobs of all sweeps by state, each once, and
/// core-hours left.
nlohmann::json campaign_json(const db::Connection& connection);

/// The newest attempts: when which worker was at work on which job.
nlohmann::json timeline_json(const db::Connection& connection);

}  // namespace eerie::serve
