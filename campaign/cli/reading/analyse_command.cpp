#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/output/outcome_tables.hpp"
#include "campaign/cli/output/status_line.hpp"
#include "campaign/worker/reanalysis.hpp"
#include "db/store/lock.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;

namespace {

struct AnalyseArguments {
  fs::path snapshot, database;
};

Answer analyse_snapshot(const AnalyseArguments& a) {
  const io::Snapshot snapshot = io::read_snapshot(a.snapshot);
  // History tells of the whole run, a snapshot of one moment: it decides nothing here.
  Answer answer;
  answer.data = remnants::to_json(
      worker::analyse_run(job_folder::JobDirectory{a.snapshot.parent_path()}, snapshot, {}));
  answer.data["time_s"] = snapshot.state.time;
  answer.data["scene"] = to_json(snapshot.scene);
  answer.say("{} at {:.6g} s\n", a.snapshot, snapshot.state.time);
  add_outcome(answer, answer.data);
  return answer;
}

Answer analyse_database(const AnalyseArguments& a, Format format) {
  db::Connection(a.database, db::Access::read_any);  // there, and ours
  const db::Lock lock(a.database);
  db::Connection connection(a.database, db::Access::write);
  CountLine line("analysed", format);
  const worker::Reanalysis report = worker::reanalyse(
      connection, [&](std::size_t done, std::size_t all) { line.show(done, all); });
  Answer answer(report.skipped.empty() ? ExitCode::done : ExitCode::job_failed);
  answer.data = {{"analysed", report.analysed}, {"skipped", report.skipped}};
  answer.say("{} results analysed again\n", report.analysed);
  for (const std::string& one : report.skipped) answer.say("skipped {}\n", one);
  return answer;
}

Answer analyse(const AnalyseArguments& a, Format format) {
  if (a.snapshot.empty() == a.database.empty())
    throw InputError(
        "analyse: give either a snapshot file or --db DATABASE, whose finished jobs are all "
        "analysed again");
  return a.database.empty() ? analyse_snapshot(a) : analyse_database(a, format);
}

}  // namespace

Action add_analyse(CLI::App& app) {
  auto a = std::make_shared<AnalyseArguments>();
  app.add_option("SNAPSHOT", a->snapshot, "snapshot file (.hdf5)");
  app.add_option("--db", a->database, "analyse every finished job of this database again");
  add_formats(app);
  return [a](Output& out) { return analyse(*a, out.format); };
}

}  // namespace eerie::cli
