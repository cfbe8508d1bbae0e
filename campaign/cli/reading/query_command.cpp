#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/options/filters.hpp"
#include "campaign/cli/output/results_table.hpp"
#include "campaign/cli/output/view_text.hpp"
#include "campaign/cli/output/files.hpp"
#include "db/store/bind.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"

namespace eerie::cli {
namespace {
namespace fs = std::filesystem;

struct QueryArguments {
  fs::path database;
  std::string of = "results";
  FilterArguments filter;
  std::string columns, sort;  ///< names with commas; empty: all, the view's own order
  std::optional<std::int64_t> limit;
  std::string format;  ///< empty: by the file's extension, else table
  fs::path file;       ///< empty: standard output
  bool json = false;
};

std::string format_of(const QueryArguments& a) {
  if (a.json) return "json";
  if (!a.format.empty()) return a.format;
  if (a.file.empty() || a.file.extension() == ".txt") return "table";
  const std::string extension = a.file.extension().string();
  if (extension == ".csv" || extension == ".json") return extension.substr(1);
  throw InputError(
      fmt::format("-o {}: does not say which format; call it .csv, .json or .txt, or give --format",
                  a.file.string()));
}

std::string text_of(const db::Connection& connection, const db::ViewQuery& query,
                    const std::string& format) {
  const db::ViewRows rows = db::rows(connection, query);
  if (rows.rows.empty()) {
    constexpr std::array one_row = {"result", "remnant", "point"};
    const std::string database = connection.path().string();
    fmt::print(stderr, "no {} in {} matches; `eerie status --db {}` shows what it holds\n",
               one_row.at(static_cast<std::size_t>(query.view)), database, database);
  }
  if (format == "csv") return csv(rows);
  if (format == "json") return records(rows).dump(1) + "\n";
  if (format == "json-table") return described(rows).dump(1) + "\n";
  if (!query.columns.empty()) return plain_table(rows);
  return query.view == db::View::results ? results_table(db::selected_results(connection, query))
                                         : short_table(rows);
}

int query(const QueryArguments& a) {
  const std::string format = format_of(a);
  const db::Connection connection(a.database, db::Access::read);
  const auto view = db::enumerator<db::View>(db::view_names, a.of);
  db::ViewQuery wanted = filtered(connection, view, a.filter);
  const std::vector<db::ViewColumn> known = db::columns(connection, view);
  wanted.columns = parse_columns(a.columns, view, known);
  wanted.sort = parse_sort(a.sort, view, known);
  wanted.limit = a.limit;
  const std::string text = text_of(connection, wanted, format);
  if (a.file.empty()) {
    fmt::print("{}", text);
  } else {
    make_folder_of(a.file);
    install_text(a.file, text);
    fmt::print("{}\n", a.file.string());
  }
  return static_cast<int>(ExitCode::done);
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
  add_json(app, a->json);
  return [a] { return query(*a); };
}

}  // namespace eerie::cli
