#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/output/progress_line.hpp"
#include "campaign/manager/doctor.hpp"
#include "db/store/lock.hpp"
#include "solver/base/error.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

struct DoctorArguments {
  fs::path database;
  bool fix = false, json = false;
};

void show_examined(std::size_t done, std::size_t total) {
  if (done % 200 == 0 || done == total) show_count("examined", done, total);
}

std::vector<manager::Problem> findings_of(const DoctorArguments& a) {
  if (!a.fix) return manager::examine(db::Connection(a.database, db::Access::read), show_examined);
  db::Connection(a.database, db::Access::read_any);  // there, and ours
  const db::Lock lock(a.database);
  db::Connection connection(a.database, db::Access::write);
  return manager::mend(connection, show_examined);
}

int doctor(const DoctorArguments& a) {
  const std::vector<manager::Problem> findings = findings_of(a);
  const auto holder = a.fix ? std::nullopt : db::lock_holder(a.database);
  const bool well = std::ranges::all_of(
      findings, [](const manager::Problem& f) { return f.mended || f.is_note; });
  if (a.json) {
    json list = json::array();
    for (const manager::Problem& f : findings)
      list.push_back(
          {{"what", f.what}, {"mend", f.mend}, {"mendable", f.mendable}, {"mended", f.mended}});
    fmt::print("{}\n", json{{"database", a.database.string()}, {"findings", list}}.dump(1));
  } else {
    for (const manager::Problem& f : findings)
      fmt::print("{}: {}\n   -> {}{}\n",
                 f.mended    ? "mended"
                 : f.is_note ? "note"
                             : "found",
                 f.what, f.mendable && !f.mended ? "with --fix: " : "", f.mend);
    if (holder)
      fmt::print("{} works on it: what is in motion may look wrong for a moment\n", *holder);
    fmt::print("{}\n",
               findings.empty() ? "all is well" : fmt::format("{} findings", findings.size()));
  }
  return static_cast<int>(well ? ExitCode::done : ExitCode::environment);
}

}  // namespace

Action add_doctor(CLI::App& app) {
  auto a = std::make_shared<DoctorArguments>();
  add_database(app, a->database);
  app.add_flag("--fix", a->fix, "mend what can be mended without losing anything");
  add_json(app, a->json);
  return [a] { return doctor(*a); };
}

}  // namespace eerie::cli
