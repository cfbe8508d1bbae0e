#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "campaign/auto_fidelity/auto_fidelity.hpp"
#include "campaign/manager/campaign_run.hpp"
#include "campaign/text/table.hpp"

namespace eerie::auto_fidelity {

/// One round of an automatic choice: the wanted runs, and how many of them are left to run.
struct AutoRound {
  int number = 1;
  std::vector<std::size_t> wanted;  ///< runs, rung by rung
  std::size_t left = 0;
};

class AutoObserver : public virtual manager::CampaignObserver {
 public:
  virtual void begins(const AutoRound& round, const AutoFidelity& campaign) = 0;
};

struct AutoPlan {
  std::string name, document;  ///< name and document of the sweep in the database
  double core_hours = 0;       ///< 0: no limit
  bool retry_failed = false;   ///< retries failed runs in the first round
};

/// Runs what the campaign wants next, round by round, until nothing is in doubt, the budget is
/// spent, all wanted runs have failed before, or a stop is requested. The caller holds the lock of
/// the database and catches stop signals.
manager::Tally run_auto(db::Connection& connection, AutoFidelity& campaign, const AutoPlan& plan,
                        const manager::Workplace& workplace, AutoObserver& observer);

/// Whether the budget pays for none of the runs that are wanted next.
bool is_budget_spent(const AutoFidelity& campaign, const AutoPlan& plan,
                     const db::Connection& connection);

/// A table of the results of each impact, for people.
text::Table table_of_cells(const AutoFidelity& campaign);

/// The core-hours of all runs behind the verdicts.
double spent_core_hours(const AutoFidelity& campaign);
/// The same by rung, for people: "0.12 sketch, 0.34 survey".
std::string hours_by_rung(const AutoFidelity& campaign);
/// Core-seconds by the names of the rungs that have runs.
nlohmann::json core_seconds_by_rung(const AutoFidelity& campaign);

/// The number of impacts whose answer is not as sure as asked.
std::size_t doubtful(const AutoFidelity& campaign);

/// Writes STEM.csv and one map (.png and .svg) per mass ratio and friction angle; returns the
/// files.
std::vector<std::filesystem::path> write_results(const AutoFidelity& campaign,
                                                 const std::filesystem::path& stem);

}  // namespace eerie::auto_fidelity
