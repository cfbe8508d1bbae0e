#include <algorithm>

#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/output/status_line.hpp"
#include "campaign/manager/doctor.hpp"
#include "db/store/lock.hpp"

namespace eerie::cli {
namespace {
using manager::Problem;

struct DoctorArguments {
  std::filesystem::path database;
  bool fix = false;
};

std::vector<Problem> problems_of(const DoctorArguments& a, Format format) {
  CountLine line("examined", format);
  const auto show = [&](std::size_t done, std::size_t all) { line.show(done, all); };
  if (!a.fix) return manager::examine(db::Connection(a.database, db::Access::read), show);
  db::Connection(a.database, db::Access::read_any);  // there, and ours
  const db::Lock lock(a.database);
  db::Connection connection(a.database, db::Access::write);
  return manager::mend(connection, show);
}

Answer doctor(const DoctorArguments& a, Format format) {
  const std::vector<Problem> problems = problems_of(a, format);
  const auto holder = a.fix ? std::nullopt : db::lock_holder(a.database);
  const bool well =
      std::ranges::all_of(problems, [](const Problem& p) { return p.mended || p.is_note; });
  Answer answer(well ? ExitCode::done : ExitCode::environment);
  const Table table =
      table_of<Problem>({{data("what"), [](const Problem& p) { return p.what; }},
                         {data("mend"), [](const Problem& p) { return p.mend; }},
                         {data("mendable"), [](const Problem& p) { return p.mendable; }},
                         {data("mended"), [](const Problem& p) { return p.mended; }}},
                        problems);
  answer.data = {{"database", a.database.string()}, {"findings", records(table)}};
  for (const Problem& p : problems)
    answer.say("{}: {}\n   -> {}{}\n",
               p.mended    ? "mended"
               : p.is_note ? "note"
                           : "found",
               p.what, p.mendable && !p.mended ? "with --fix: " : "", p.mend);
  if (holder)
    answer.say("{} works on it: what is in motion may look wrong for a moment\n", *holder);
  answer.say("{}\n",
             problems.empty() ? "all is well" : fmt::format("{} findings", problems.size()));
  return answer;
}

}  // namespace

Action add_doctor(CLI::App& app) {
  auto a = std::make_shared<DoctorArguments>();
  add_database(app, a->database);
  app.add_flag("--fix", a->fix, "mend what can be mended without losing anything");
  add_formats(app);
  return [a](Output& out) { return doctor(*a, out.format); };
}

}  // namespace eerie::cli
