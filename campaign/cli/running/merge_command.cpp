#include "campaign/cli/options/command_list.hpp"
#include "campaign/merging/merge.hpp"
#include "solver/base/text/shell_word.hpp"

namespace eerie::cli {
namespace {
namespace fs = std::filesystem;
using merging::SourceReport;

struct MergeArguments {
  std::vector<fs::path> databases;
  fs::path output;
  merging::MergeOptions options;
};

std::vector<SourceReport> merged(const MergeArguments& a) {
  if (!a.output.empty()) return merging::merge_as(a.output, a.databases, a.options);
  if (a.databases.size() < 2)
    throw InputError(fmt::format(
        "{}: alone is nothing to merge; give the databases that it takes in, or -o FILE "
        "for a new one",
        a.databases.front().string()));
  return merging::merge_into(a.databases.front(), {a.databases.begin() + 1, a.databases.end()},
                             a.options);
}

Table table_of_sources(const std::vector<SourceReport>& reports) {
  return table_of<SourceReport>(
      {{both("database", "from"), [](const SourceReport& r) { return r.database.string(); }},
       {both("jobs", "jobs"), [](const SourceReport& r) { return r.merged.jobs; }},
       {both("added", "new"), [](const SourceReport& r) { return r.merged.added; }},
       {both("results", "results taken"), [](const SourceReport& r) { return r.merged.results; }},
       {both("attempts", "attempts taken"),
        [](const SourceReport& r) { return r.merged.attempts; }},
       {both("job_directories", "job folders"), [](const SourceReport& r) { return r.files; }},
       {data("missing_job_directories"), [](const SourceReport& r) { return r.missing; }},
       {data("differing"), [](const SourceReport& r) { return r.merged.differing; }}},
      reports);
}

void add_warnings(Answer& answer, const SourceReport& report) {
  const std::string name = text::plain_text(report.database.string());
  if (report.missing > 0)
    answer.warn(fmt::format(
        "{}: the job directories of {} are not there; their numbers are, their snapshots are not",
        name, count_of(report.missing, "job")));
  if (const auto& differing = report.merged.differing; !differing.empty())
    answer.warn(fmt::format(
        "{}: {} with another result of the same solver version ({}, ...); what was there stays. "
        "Other compilers or processors do this",
        name, count_of(differing.size(), "job"), differing.front().substr(0, 8)));
}

Answer merge(const MergeArguments& a) {
  const fs::path& target = a.output.empty() ? a.databases.front() : a.output;
  const std::vector<SourceReport> reports = merged(a);
  Answer answer;
  Table table = table_of_sources(reports);
  answer.data = {{"database", target.string()}, {"sources", records(table)}};
  answer.add(std::move(table));
  answer.say("\n{} holds them; `eerie status --db {}` shows what is done and what is left\n",
             target, shell_word(target.string()));
  for (const SourceReport& report : reports) add_warnings(answer, report);
  return answer;
}

}  // namespace

Action add_merge(CLI::App& app) {
  auto a = std::make_shared<MergeArguments>();
  app.add_option("DATABASE", a->databases, "databases; without -o the first takes in the others")
      ->required();
  app.add_option("-o,--output", a->output, "put all of them into this new database instead");
  app.add_flag("--copy", a->options.copies_files,
               "copy the job directories; otherwise links lead to them");
  add_formats(app);
  return [a](Output&) { return merge(*a); };
}

}  // namespace eerie::cli
