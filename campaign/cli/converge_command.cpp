#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "campaign/cli/commands.hpp"
#include "campaign/cli/text_table.hpp"
#include "campaign/cli/work.hpp"
#include "campaign/job.hpp"
#include "campaign/signals.hpp"
#include "campaign/study_results.hpp"
#include "db/jobs.hpp"
#include "db/lock.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

std::vector<StudyRun> chosen_runs(const Study& study, const ConvergeArguments& a,
                                  const db::Connection& connection) {
  std::vector<StudyRun> runs = runs_of(study);
  if (a.core_hours == 0) return runs;
  const db::Speed speed = db::speed(connection);
  return affordable(std::move(runs), a.core_hours, speed.is_measured() ? speed : assumed_speed);
}

std::vector<db::NewJob> jobs_of_runs(const std::vector<StudyRun>& runs) {
  std::vector<Scene> scenes;
  for (const StudyRun& run : runs) scenes.push_back(run.scene);
  return jobs_of(scenes);
}

std::string range(const Ensemble& e, int digits) {
  if (e.runs == 0) return "-";
  if (e.runs == 1) return fmt::format("{:.{}f}", e.mean, digits);
  return fmt::format("{:.{}f} +- {:.{}f}", e.mean, digits, e.deviation, digits);
}

std::string table_of(const std::vector<StudyCell>& cells) {
  std::vector<std::vector<std::string>> rows = {{"case", "scheme", "particles", "runs", "b/a",
                                                 "c/a", "M_1/M", "period h", "P(EER)", "unsettled",
                                                 "core-s"}};
  for (const StudyCell& c : cells)
    rows.push_back({c.case_name, c.scheme, fmt::format("{}", c.particles_per_target),
                    fmt::format("{}", c.m_1.runs), range(c.b_over_a, 3), range(c.c_over_a, 3),
                    range(c.m_1, 3), range(c.period_h, 1), fmt::format("{:.2f}", c.p_eer),
                    fmt::format("{:.2f}", c.unsettled),
                    fmt::format("{:.0f}", c.core_seconds.mean)});
  return text_table(rows);
}

std::vector<fs::path> write_all(const Study& study, const std::vector<StudyResult>& results,
                                const std::vector<StudyCell>& cells, const fs::path& folder,
                                const JobFolder& jobs) {
  std::vector<fs::path> files = {folder / "runs.csv", folder / "convergence.csv"};
  install_text(files[0], runs_csv(results));
  install_text(files[1], cells_csv(cells));
  const auto draw = [&](const std::string& name, const std::optional<ConvergenceFigure>& figure) {
    if (!figure) return;
    files.push_back(folder / (name + ".svg"));
    draw_convergence(files.back(), *figure);
  };
  for (const Study::Case& one : study.cases) {
    draw(one.name, figure_of(study, one, cells));
    draw(one.name + "-diagnosis", diagnosis_figure(study, one, results, jobs));
  }
  return files;
}

/// Runs what the budget pays and is not done yet.
Tally run_study(const Study& study, const ConvergeArguments& a) {
  catch_stop_signals();
  hold_signals();
  make_folder_of(a.database);
  const db::Lock lock(a.database);
  db::Connection connection(a.database, db::Access::write);
  const std::vector<StudyRun> runs = chosen_runs(study, a, connection);
  if (runs.empty())
    throw InputError(
        fmt::format("--budget = {:g}: does not pay for the first run; raise it", a.core_hours));
  const db::AddedSweep added =
      db::add_sweep(connection, study.name, study.document.dump(), jobs_of_runs(runs));
  const std::size_t left = tally(connection, added.sweep).left;
  if (!a.json) {
    fmt::print("{}: {} runs within the budget, {} to run\n", study.name, runs.size(), left);
    std::fflush(stdout);
  }
  if (left > 0) work(connection, {a.workers, a.threads_per_job, a.json}, added.sweep);
  return tally(connection, added.sweep);
}

}  // namespace

int converge(const ConvergeArguments& a) {
  const Study study = load_study(a.study);
  const Tally left = a.draw_only ? Tally{} : run_study(study, a);
  const db::Connection connection(a.database, db::Access::read);
  const std::vector<StudyResult> results = finished_runs(connection, runs_of(study));
  if (results.empty())
    throw InputError(fmt::format("{}: the database {} has no result of this study",
                                 a.study.string(), a.database.string()));
  make_folder_of(a.folder / "runs.csv");
  const std::vector<StudyCell> cells = cells_of(study, results);
  const std::vector<fs::path> files =
      write_all(study, results, cells, a.folder, job_folder(connection));
  if (a.json) {
    json names = json::array();
    for (const fs::path& file : files) names.push_back(file.string());
    fmt::print("{}\n", json{{"study", study.name},
                            {"results", results.size()},
                            {"failed", left.failed},
                            {"left", left.left},
                            {"files", std::move(names)}}
                           .dump(1));
  } else {
    fmt::print("\n{}\n{} results", table_of(cells), results.size());
    if (left.failed > 0) fmt::print(", {} failed (eerie status says why)", left.failed);
    if (left.left > 0) fmt::print(", {} left", left.left);
    fmt::print("\n");
    for (const fs::path& file : files) fmt::print("{}\n", file.string());
  }
  if (left.left > 0) {
    fmt::print(stderr, "stopped; the same command goes on from the checkpoints\n");
    return stopped_by_signal;
  }
  return static_cast<int>(left.failed > 0 ? ExitCode::job_failed : ExitCode::done);
}

}  // namespace eerie::cli
