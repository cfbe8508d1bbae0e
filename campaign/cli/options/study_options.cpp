#include "campaign/cli/options/study_options.hpp"

namespace eerie::cli {

void add_study(CLI::App& app, StudyArguments& a) {
  app.add_option("STUDY", a.study, "study file")->required();
  add_database(app, a.plan.database);
  app.add_option("--known", a.plan.known,
                 "runs.csv that this command wrote before or elsewhere: what stands in it is not "
                 "run again; may be given several times")
      ->allow_extra_args(false)
      ->check(CLI::ExistingFile);
  app.add_option("--budget", a.plan.core_hours,
                 "core-hours that the study may cost, finished runs included (default: no limit)")
      ->check(CLI::Range(0.001, 1e7));
  add_share(app, a.share.workers, a.share.threads_per_job);
  app.add_flag("--draw-only", a.plan.draw_only, "run nothing: figures and tables of what is there");
  add_formats(app);
}

Answer study_answer(const StudyArguments& arguments, const std::string& study, std::size_t results,
                    const manager::Tally& left, const std::vector<std::filesystem::path>& files) {
  Answer answer;
  conclude(answer, left, arguments.plan.database, " from the checkpoints");
  answer.data = {{"study", study},
                 {"results", results},
                 {"failed", left.failed},
                 {"left", left.left},
                 {"files", names_of(files)}};
  return answer;
}

}  // namespace eerie::cli
