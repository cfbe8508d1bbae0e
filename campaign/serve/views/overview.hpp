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

/// The state of a campaign at one moment, for the first view of the dashboard.
struct Overview {
  std::vector<db::SweepStatus> sweeps;
  std::vector<db::FailureGroup> failures;
  db::Speed speed;
  std::optional<std::string> holder;
  std::optional<manager::CampaignView> at_work;  ///< reported by the manager
  std::vector<manager::Silence> silent;
  job_folder::JobFolder folder;
  /// Found here, since a manager on a full disk cannot report it.
  std::optional<std::string> no_room = {};
};
Overview overview_of(const db::Connection& connection);

std::int64_t count(const db::SweepStatus& sweep, db::JobState state);
/// The core-hours that a sweep still needs at the measured speed; nothing without a measurement.
std::optional<double> core_hours_left(const db::SweepStatus& sweep, const db::Speed& speed);

nlohmann::json to_json(const Overview& overview, const std::filesystem::path& database);

/// The process that works on a database and its report: {"worked_on_by", "at_work"}, null where
/// there is none. It opens no database.
nlohmann::json work_json(const std::filesystem::path& database);

/// to_json() with further numbers of the first view: the distinct jobs of all sweeps by state, and
/// the core-hours left.
nlohmann::json campaign_json(const db::Connection& connection);

/// The newest attempts, with time, worker and job.
nlohmann::json timeline_json(const db::Connection& connection);

}  // namespace eerie::serve
