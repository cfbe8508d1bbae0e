#include <array>

#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/output/files.hpp"
#include "campaign/results/results_table.hpp"
#include "campaign/results/view_tables.hpp"
#include "db/store/bind.hpp"

namespace eerie::cli {
namespace {
namespace fs = std::filesystem;

struct QueryArguments {
  fs::path database;
  std::string of = "results";
  queries::Filter filter;
  std::string columns, sort;  ///< names with commas; empty: all, the view's own order
  std::optional<std::int64_t> limit;
  std::string format;  ///< empty: by the file's extension, else table
  fs::path file;       ///< empty: standard output
};

std::string format_of(const QueryArguments& a, const Output& out) {
  if (out.format == Format::json) return "json";
  if (!a.format.empty()) return a.format;
  if (a.file.empty() || a.file.extension() == ".txt") return "table";
  const std::string extension = a.file.extension().string();
  if (extension == ".csv" || extension == ".json") return extension.substr(1);
  throw InputError(
      fmt::format("-o {}: does not say which format; call it .csv, .json or .txt, or give --format",
                  a.file.string()));
}

Answer answer_of(const db::Connection& connection, const db::ViewQuery& query, bool with_meanings) {
  const db::ViewRows rows = db::rows(connection, query);
  Answer answer;
  if (rows.rows.empty()) {
    constexpr std::array one_row = {"result", "remnant", "point"};
    complain(line("no {} in {} matches; {}", one_row.at(static_cast<std::size_t>(query.view)),
                  connection.path(), see_status(connection.path())));
  }
  Table table = query.columns.empty() ? results::short_table(rows) : results::plain_table(rows);
  answer.data = with_meanings ? results::described(rows) : records(table);
  answer.add(std::move(table));
  if (query.columns.empty() && query.view == db::View::results) {
    const std::vector<db::ResultRow> results = db::selected_results(connection, query);
    answer.add(results::results_table(results), results::legend_of(connection, results));
  }
  return answer;
}

Answer query(const QueryArguments& a, Output& out) {
  const std::string name = format_of(a, out);
  const db::Connection connection(a.database, db::Access::read);
  const auto view = db::enumerator<db::View>(db::view_names, a.of);
  db::ViewQuery wanted = queries::filtered(connection, view, a.filter);
  const std::vector<db::ViewColumn> known = db::columns(connection, view);
  wanted.columns = queries::parse_columns(a.columns, view, known);
  wanted.sort = queries::parse_sort(a.sort, view, known);
  wanted.limit = a.limit;
  Answer answer = answer_of(connection, wanted, name == "json-table");
  const Format format = name == "csv"     ? Format::csv
                        : name == "table" ? Format::people
                                          : Format::json;
  const bool to_file = !a.file.empty();
  if (out.format != Format::nothing) out.format = to_file ? Format::people : format;
  if (!to_file) return answer;
  install(a.file, rendered(answer, format, 0));
  Answer installed;
  installed.add_files({a.file});
  return installed;
}

}  // namespace

Action add_query(CLI::App& app) {
  auto a = std::make_shared<QueryArguments>();
  add_database(app, a->database);
  app.add_option("--of", a->of, "results (one row per job), remnants, or maps (one per point)")
      ->check(CLI::IsMember({"results", "remnants", "maps"}))
      ->capture_default_str();
  add_filters(app, a->filter);
  app.add_option("--columns", a->columns, "only these columns, in this order: a,b,c");
  app.add_option("--sort", a->sort, "by these columns, a,-b: a rising, then b falling");
  app.add_option("--limit", a->limit, "so many rows at most")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1'000'000'000}));
  app.add_option("--format", a->format,
                 "table, csv, json (a list of rows) or json-table (with units and meanings); "
                 "default: as the file is called, else table")
      ->check(CLI::IsMember({"table", "csv", "json", "json-table"}));
  app.add_option("-o,--output", a->file, "write into this file");
  add_formats(app);
  return [a](Output& out) { return query(*a, out); };
}

}  // namespace eerie::cli
