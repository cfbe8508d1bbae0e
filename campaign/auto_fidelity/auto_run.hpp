#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "campaign/auto_fidelity/auto_fidelity.hpp"
#include "campaign/manager/campaign_run.hpp"
#include "campaign/text/table.hpp"

namespace eerie::auto_fidelity {

/// One round of an automatic choice: what is known, what is wanted, how much of it is to be run.
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
  std::string name, document;  ///< of the sweep that the database gets
  double core_hours = 0;       ///< 0: no limit
  bool retry_failed = false;   ///< in the first round
};

/// Runs rounds of what the campaign wants next until nothing is in doubt, the budget is spent, what
/// is wanted has failed before, or a stop is asked for. The caller holds the database's lock and
/// catches stop signals.
manager::Tally run_auto(db::Connection& connection, AutoFidelity& campaign, const AutoPlan& plan,
                        const manager::Workplace& workplace, AutoObserver& observer);

/// What is known of each impact, for people.
text::Table table_of_cells(const AutoFidelity& campaign);

/// Core-hours of all runs that the verdicts made use of.
double spent_core_hours(const AutoFidelity& campaign);

/// Impacts whose answer is not as sure as asked.
std::size_t doubtful(const AutoFidelity& campaign);

/// Writes STEM.csv and one map (.png and .svg) per mass ratio and friction angle; returns the
/// files.
std::vector<std::filesystem::path> write_results(const AutoFidelity& campaign,
                                                 const std::filesystem::path& stem);

}  // namespace eerie::auto_fidelity
