#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/options/study_options.hpp"
#include "campaign/studies/cost_files.hpp"
#include "campaign/text/given_folder.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;

namespace {

struct ChartArguments {
  StudyArguments work;
  fs::path picture;
};

Answer chart(const ChartArguments& a, Output& out) {
  text::require_folder_of(a.picture);
  const studies::CostStudy study = studies::load_cost_study(a.work.study);
  const auto [left, results, jobs] = watch_study(a.work, study, studies::runs_of(study), out);
  const std::vector<studies::CostPoint> points = studies::cost_points(study, results);
  if (points.empty())
    throw InputError(fmt::format(
        "{}: the database {} lacks the reference's result of some case: nothing to measure against",
        a.work.study.string(), a.work.plan.database.string()));
  const std::vector<fs::path> files = studies::write_cost_study(study, results, points, a.picture);
  Answer answer = study_answer(a.work, study.name, results.size(), left, files);
  answer.data["points"] = points.size();
  answer.say("\n");
  answer.add(studies::table_of_points(study, points));
  answer.say(
      "\nerrors against the reference, in brackets what the spread of the seeds alone gives; "
      "*: on the frontier of b/a\n{} results\n",
      results.size());
  answer.add_files(files);
  return answer;
}

}  // namespace

Action add_chart(CLI::App& app) {
  auto a = std::make_shared<ChartArguments>();
  add_study(app, a->work);
  app.add_option("-o,--output", a->picture,
                 "picture: .svg, .png or .pdf; its numbers come beside it as CSV")
      ->required();
  return [a](Output& out) { return chart(*a, out); };
}

}  // namespace eerie::cli
