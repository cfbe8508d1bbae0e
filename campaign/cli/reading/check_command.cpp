#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/output/files.hpp"
#include "campaign/facts/fact_report.hpp"
#include "solver/base/file.hpp"

namespace eerie::cli {
namespace {

struct CheckArguments {
  std::filesystem::path database;
  std::filesystem::path report;  ///< empty: none
  db::MapFilter filter;          ///< of settings only
};

Answer answer_of(const facts::FactReport& r) {
  Answer answer;
  answer.data = facts::to_json(r);
  answer.add(facts::table_of_facts(r));
  answer.say("\n");
  for (const facts::CheckedFact& c : r.facts)
    if (!c.finding.difference.empty())
      answer.say("{}: {}: {}\n", c.fact->name, paper::name(c.finding.agreement),
                 c.finding.difference);
  const auto commands = facts::commands_of(r);
  if (!commands.empty()) answer.say("\nwhat would decide the open ones:\n");
  for (const auto& [command, names] : commands) answer.say("{}:\n    {}\n", names, command);
  answer.say("\n{}\n{}\n{}\n", facts::summary(r), facts::rules(), facts::other_means);
  if (!r.remark.empty()) answer.say("{}\n", r.remark);
  return answer;
}

Answer check(const CheckArguments& a) {
  if (!a.report.empty() && a.report.extension() != ".md")
    throw InputError(
        fmt::format("-o {}: the report is Markdown; its name must end in .md, for "
                    "example -o report.md",
                    a.report.string()));
  const db::Connection connection(a.database, db::Access::read);
  facts::FactReport report = facts::check_facts(connection, a.filter);
  if (a.report.empty()) return answer_of(report);
  text::require_folder_of(a.report);
  facts::draw_maps(report, connection, a.filter, a.report);
  install_text(a.report, facts::markdown(report));
  Answer answer = answer_of(report);
  answer.add_files({a.report});
  answer.add_files(report.figures);
  return answer;
}

}  // namespace

Action add_check(CLI::App& app) {
  auto a = std::make_shared<CheckArguments>();
  add_database(app, a->database);
  add_settings_filter(app, a->filter);
  app.add_option("-o,--output", a->report,
                 "write the table, with maps beside it, into this Markdown file (.md)");
  add_formats(app);
  return [a](Output&) { return check(*a); };
}

}  // namespace eerie::cli
