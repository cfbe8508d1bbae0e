#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/options/study_options.hpp"
#include "campaign/studies/convergence_files.hpp"
#include "campaign/text/given_folder.hpp"
#include "solver/base/text/shell_word.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;

namespace {

struct ConvergeArguments {
  StudyArguments work;
  fs::path folder;
};

Answer converge(const ConvergeArguments& a, Output& out) {
  const studies::ConvergenceStudy study = studies::load_convergence_study(a.work.study);
  text::make_given_folder(a.folder);  // before hours of work
  auto [left, results, jobs] = watch_study(a.work, study, studies::runs_of(study), out);
  if (results.empty())
    throw InputError(fmt::format("{}: the database {} has no result of this study{}",
                                 a.work.study.string(), a.work.plan.database.string(),
                                 a.work.plan.known.empty() ? "" : ", nor have the known tables"));
  studies::look_up_published_time(study, results, jobs);
  const std::vector<studies::ConvergenceCell> cells = studies::cells_of(study, results);
  const std::vector<fs::path> files =
      studies::write_convergence_study(study, results, a.folder, jobs);
  Answer answer = study_answer(a.work, study.name, results.size(), left, files);
  answer.say("\n");
  answer.add(studies::table_of_cells(cells));
  answer.say("\n");
  answer.add(studies::table_of_particles_needed(studies::particles_needed(study, cells)));
  answer.say("\n{} results{}{}\n", results.size(),
             left.failed > 0 ? fmt::format(", {} failed (`eerie status --db {}` says why)",
                                           left.failed, shell_word(a.work.plan.database.string()))
                             : "",
             left.left > 0 ? fmt::format(", {} left", left.left) : "");
  answer.add_files(files);
  return answer;
}

}  // namespace

Action add_converge(CLI::App& app) {
  auto a = std::make_shared<ConvergeArguments>();
  add_study(app, a->work);
  app.add_option("-o,--output", a->folder, "folder for figures and tables")->required();
  return [a](Output& out) { return converge(*a, out); };
}

}  // namespace eerie::cli
