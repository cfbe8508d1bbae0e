#pragma once

#include "campaign/cli/options/options.hpp"
#include "campaign/cli/options/scheduler_options.hpp"
#include "campaign/cli/output/campaign_watch.hpp"
#include "campaign/cli/output/files.hpp"
#include "campaign/studies/study_run.hpp"

namespace eerie::cli {

/// The options that commands for studies share.
struct StudyArguments {
  std::filesystem::path study;
  studies::StudyPlan plan;  ///< without name and document
  manager::Share share;
};
void add_study(CLI::App& app, StudyArguments& arguments);

/// Calls studies::work_on_study() and shows its progress.
template <class Study, class Run>
studies::StudyWork<Run> watch_study(StudyArguments a, const Study& study,
                                    const std::vector<Run>& runs, Output& out) {
  a.plan.name = study.name, a.plan.document = study.document.dump();
  if (!a.plan.draw_only) make_folder_of_database(a.plan.database);
  CampaignWatch watch(study.name, out);
  return studies::work_on_study(a.plan, runs, workplace({}, a.share), watch);
}

/// The answer {"study", "results", "failed", "left", "files"}, with its exit code.
Answer study_answer(const StudyArguments& arguments, const std::string& study, std::size_t results,
                    const manager::Tally& left, const std::vector<std::filesystem::path>& files);

}  // namespace eerie::cli
