#include <chrono>

#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/output/failures.hpp"
#include "campaign/cli/output/progress_line.hpp"
#include "campaign/overview/campaign_look.hpp"
#include "campaign/process/signals.hpp"
#include "solver/base/text/shell_word.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;

namespace {

struct StatusArguments {
  fs::path database;
  bool watch = false;
};

Answer answer_of(const overview::CampaignLook& look, const fs::path& database) {
  Answer answer;
  answer.data = overview::to_json(look, database);
  answer.say("{}: {}\n", database,
             look.holder ? "worked on by " + *look.holder : "nobody works on it");
  if (look.at_work) answer.say("{}\n", progress_tail(*look.at_work));
  if (look.no_room && (!look.at_work || look.at_work->waiting_for.empty()))
    answer.say("waiting: {}\n", *look.no_room);
  answer.say("\n");
  answer.add(overview::table_of_sweeps(look));
  if (!look.failures.empty()) answer.say("\n");
  add_failures(answer, look.failures, look.folder);
  for (const manager::Silence& s : look.silent)
    answer.say("\nsilent: job {} on {} gave no sign of life for {}; `eerie log {} --db {}`\n",
               s.hash.substr(0, 16), s.host, duration(s.seconds), s.hash.substr(0, 8),
               shell_word(database.string()));
  return answer;
}

Answer watch(const fs::path& database, Output& out) {
  process::catch_stop_signals();
  process::hold_signals();
  while (process::stop_requests() == 0 && !out.is_over()) {
    const Answer now = answer_of(overview::look_at(database), database);
    out.begin_page();
    out.print(now);
    process::wait_for_signal(std::chrono::seconds(2));
  }
  return {};
}

Answer status(const StatusArguments& a, Output& out) {
  if (a.watch && out.format != Format::people)
    throw InputError("--watch, and --json or --quiet: give one of them");
  return a.watch ? watch(a.database, out) : answer_of(overview::look_at(a.database), a.database);
}

}  // namespace

Action add_status(CLI::App& app) {
  auto a = std::make_shared<StatusArguments>();
  add_database(app, a->database);
  app.add_flag("--watch", a->watch, "show it anew every two seconds, until Ctrl-C");
  add_formats(app);
  return [a](Output& out) { return status(*a, out); };
}

}  // namespace eerie::cli
