#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/output/outcome_text.hpp"
#include "campaign/cli/output/progress_line.hpp"
#include "campaign/worker/reanalysis.hpp"
#include "db/store/lock.hpp"
#include "solver/base/error.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

struct AnalyseArguments {
  fs::path snapshot, database;
  bool json = false;
};

int analyse_snapshot(const AnalyseArguments& a) {
  const io::Snapshot snapshot = io::read_snapshot(a.snapshot);
  // History tells of the whole run, a snapshot of one moment: it decides nothing here.
  const remnants::Analysis analysis =
      worker::analyse_run(job_folder::JobDirectory{a.snapshot.parent_path()}, snapshot, {});
  if (a.json) {
    json report = remnants::to_json(analysis);
    report["time_s"] = snapshot.state.time;
    report["scene"] = to_json(snapshot.scene);
    fmt::print("{}\n", report.dump(1));
  } else {
    fmt::print("{} at {:.6g} s\n{}", a.snapshot.string(), snapshot.state.time,
               outcome_text(analysis));
  }
  return static_cast<int>(ExitCode::done);
}

int analyse_database(const AnalyseArguments& a) {
  db::Connection(a.database, db::Access::read_any);  // there, and ours
  const db::Lock lock(a.database);
  db::Connection connection(a.database, db::Access::write);
  const worker::Reanalysis report = worker::reanalyse(
      connection, [](std::size_t done, std::size_t all) { show_count("analysed", done, all); });
  if (a.json)
    fmt::print("{}\n", json{{"analysed", report.analysed}, {"skipped", report.skipped}}.dump(1));
  else
    fmt::print("{} results analysed again\n", report.analysed);
  if (!a.json)
    for (const std::string& line : report.skipped) fmt::print("skipped {}\n", line);
  return static_cast<int>(report.skipped.empty() ? ExitCode::done : ExitCode::job_failed);
}

int analyse(const AnalyseArguments& a) {
  if (a.snapshot.empty() == a.database.empty())
    throw InputError(
        "analyse: give either a snapshot file or --db DATABASE, whose finished jobs are all "
        "analysed again");
  return a.database.empty() ? analyse_snapshot(a) : analyse_database(a);
}

}  // namespace

Action add_analyse(CLI::App& app) {
  auto a = std::make_shared<AnalyseArguments>();
  app.add_option("SNAPSHOT", a->snapshot, "snapshot file (.hdf5)");
  app.add_option("--db", a->database, "analyse every finished job of this database again");
  add_json(app, a->json);
  return [a] { return analyse(*a); };
}

}  // namespace eerie::cli
