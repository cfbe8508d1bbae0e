#include "campaign/cli/options/command_list.hpp"
#include "campaign/comparison/comparison_table.hpp"

namespace eerie::cli {
namespace {
namespace fs = std::filesystem;

struct CompareArguments {
  fs::path a, b;  ///< b is empty: the same database
  std::string of, with, format;
};

Answer compare(const CompareArguments& a, Output& out) {
  if (a.b.empty() && (a.of.empty() || a.with.empty()))
    throw InputError(fmt::format(
        "{}: one database is compared with itself by two of its settings; give --of and --with "
        "(fidelities, or numbers of settings), or a second database",
        a.a.string()));
  const db::Connection first(a.a, db::Access::read);
  const db::Connection second(a.b.empty() ? a.a : a.b, db::Access::read);
  const comparison::Compared all =
      comparison::compare({&first, a.of}, {&second, a.with.empty() ? a.of : a.with});
  Answer answer;
  Table table = comparison::table_of_impacts(all);
  answer.data = {{"impacts", records(table)}, {"only_a", all.only_a}, {"only_b", all.only_b}};
  answer.add(std::move(table));
  answer.say("\n");
  answer.add_text(comparison::summary(all));
  if (out.format == Format::people && a.format == "csv") out.format = Format::csv;
  if (out.format == Format::people && a.format == "json") out.format = Format::json;
  return answer;
}

}  // namespace

Action add_compare(CLI::App& app) {
  auto a = std::make_shared<CompareArguments>();
  app.add_option("A", a->a, "database")->required();
  app.add_option("B", a->b, "the other database (default: the same one)");
  app.add_option("--of", a->of, "only results of this fidelity, or settings by their number, in A");
  app.add_option("--with", a->with, "the same in B (default: that of --of)");
  app.add_option("--format", a->format, "table, csv or json (default: table)")
      ->check(CLI::IsMember({"table", "csv", "json"}));
  add_formats(app);
  return [a](Output& out) { return compare(*a, out); };
}

}  // namespace eerie::cli
