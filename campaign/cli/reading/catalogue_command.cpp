#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/remnants/outcome.hpp"
#include "campaign/catalogue/catalogue_export.hpp"
#include "campaign/catalogue/catalogue_sweep.hpp"
#include "campaign/catalogue/comparison.hpp"
#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/options/filters.hpp"
#include "campaign/cli/output/text_table.hpp"
#include "campaign/cli/output/files.hpp"
#include "campaign/sweeps/fidelity.hpp"
#include "campaign/sweeps/job.hpp"
#include "campaign/text/csv.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"

namespace eerie::cli {
namespace {
namespace fs = std::filesystem;
using nlohmann::json;

/// Of all three commands; each uses its own.
struct CatalogueArguments {
  fs::path database, catalogue, output;
  FilterArguments filter;
  catalogue::CatalogueOptions options;
  SceneChanges changes;
  bool json = false;
};

catalogue::Catalogue load(const CatalogueArguments& a) {
  std::error_code ignored;
  if (!fs::is_regular_file(a.catalogue, ignored))
    throw InputError(a.catalogue.string() + ": there is no such file; give a catalogue as CSV");
  catalogue::Catalogue catalogue =
      catalogue::parse_catalogue(read_file(a.catalogue), a.catalogue.string(), a.options);
  if (!catalogue.ignored.empty())
    fmt::print(stderr, "not used: {}\n", fmt::join(catalogue.ignored, ", "));
  return catalogue;
}

void install(const fs::path& file, const std::string& text) {
  make_folder_of(file);
  install_text(file, text);
}

int export_catalogue(const CatalogueArguments& a) {
  const db::Connection connection(a.database, db::Access::read);
  const std::string text =
      catalogue::catalogue_csv(connection, filtered(connection, db::View::results, a.filter));
  const auto impacts = std::ranges::count(text, '\n') - 1;
  if (a.output.empty()) {
    fmt::print("{}", text);
  } else {
    install(a.output, text);
    fmt::print("{}: {} impacts\n", a.output.string(), impacts);
  }
  if (impacts == 0)
    fmt::print(stderr, "no result in {} matches; `eerie status --db {}` shows what it holds\n",
               a.database.string(), a.database.string());
  return static_cast<int>(ExitCode::done);
}

int import_catalogue(const CatalogueArguments& a) {
  const catalogue::Catalogue catalogue = load(a);
  SceneChanges changes = a.changes;
  const std::string name = a.catalogue.string();
  if (changes.fidelity.empty()) changes.fidelity = catalogue::common_fidelity(catalogue, name);
  json document = catalogue::sweep_of(catalogue, changes.all(), name);
  const fs::path file = a.output.empty() ? a.catalogue.stem().concat(".json") : a.output;
  document["name"] = catalogue::sweep_name_of(file.stem());
  document["description"] = "impacts of " + a.catalogue.filename().string();
  const sweeps::Sweep sweep = sweeps::parse_sweep(document, {}, file.string());
  const std::vector<Scene> scenes = sweeps::expand(sweep);
  install(file, document.dump(1) + "\n");
  if (a.json) {
    fmt::print("{}\n", json{{"sweep", file.string()},
                            {"lines", catalogue.rows.size()},
                            {"impacts", scenes.size()},
                            {"ignored", catalogue.ignored}}
                           .dump(1));
    return static_cast<int>(ExitCode::done);
  }
  print_warnings(sweeps::cautions(scenes));
  fmt::print("{}: {} impacts of {} lines; `eerie run {}` runs them\n", file.string(), scenes.size(),
             catalogue.rows.size(), file.string());
  return static_cast<int>(ExitCode::done);
}

json or_null(const std::optional<double>& value) { return value ? json(*value) : json(); }

/// Fields of a comparison, in the order of the CSV.
constexpr const char* csv_columns[] = {"run_id",
                                       "line",
                                       "v_imp_cm_per_s",
                                       "theta_imp_deg",
                                       "q",
                                       "settings",
                                       "runs",
                                       "class",
                                       "class_ours",
                                       "runs_of_class",
                                       "m_lr_over_m_total",
                                       "m_lr_over_m_total_ours",
                                       "m_lr_scatter",
                                       "m_lr_difference",
                                       "m_slr_over_m_total",
                                       "m_slr_over_m_total_ours",
                                       "b_over_a",
                                       "b_over_a_ours"};

json to_json(const catalogue::Comparison& c) {
  const catalogue::CatalogueRow& row = *c.row;
  const auto ours = [&](const json& value) { return c.runs > 0 ? value : json(); };
  return {{"run_id", row.run_id},
          {"line", row.line},
          {"v_imp_cm_per_s", row.impact.v_imp_cm_per_s},
          {"theta_imp_deg", row.impact.theta_imp_deg},
          {"q", row.impact.q},
          {"settings", ours(c.settings)},
          {"runs", c.runs},
          {"class", row.outcome.outcome_class.empty() ? json() : json(row.outcome.outcome_class)},
          {"class_ours", ours(c.outcome_class)},
          {"runs_of_class", ours(c.of_class)},
          {"m_lr_over_m_total", or_null(row.outcome.m_lr_over_m_total)},
          {"m_lr_over_m_total_ours", ours(c.m_lr_over_m_total)},
          {"m_lr_scatter", c.runs > 1 ? json(c.m_lr_scatter) : json()},
          {"m_lr_difference", or_null(c.m_lr_difference())},
          {"m_slr_over_m_total", or_null(row.outcome.m_slr_over_m_total)},
          {"m_slr_over_m_total_ours", ours(c.m_slr_over_m_total)},
          {"b_over_a", or_null(row.outcome.b_over_a)},
          {"b_over_a_ours", or_null(c.b_over_a)}};
}

std::string csv_of(const std::vector<catalogue::Comparison>& all) {
  std::string text = fmt::format("{}\n", fmt::join(csv_columns, ","));
  for (const catalogue::Comparison& c : all) {
    const json record = to_json(c);
    std::vector<std::string> fields;
    for (const char* column : csv_columns) {
      const json& value = record.at(column);
      fields.push_back(value.is_null()     ? ""
                       : value.is_string() ? text::csv_field(value.get<std::string>())
                                           : value.dump());
    }
    text += fmt::format("{}\n", fmt::join(fields, ","));
  }
  return text;
}

std::string table_of(const std::vector<catalogue::Comparison>& all) {
  const auto number = [](const std::optional<double>& value, const char* pattern = "{:.3f}") {
    return value ? fmt::format(fmt::runtime(pattern), *value) : std::string("-");
  };
  std::vector<std::vector<std::string>> table = {{"run", "v cm/s", "theta deg", "q", "class",
                                                  "M_lr/M", "settings", "runs", "ours", "of",
                                                  "M_lr/M ours", "+-", "difference"}};
  for (const catalogue::Comparison& c : all) {
    const catalogue::CatalogueRow& row = *c.row;
    const bool ran = c.runs > 0;
    table.push_back(
        {row.run_id.empty() ? fmt::format("line {}", row.line) : row.run_id,
         fmt::format("{:.5g}", row.impact.v_imp_cm_per_s),
         fmt::format("{:.4g}", row.impact.theta_imp_deg), fmt::format("{:.4g}", row.impact.q),
         row.outcome.outcome_class.empty() ? "-" : row.outcome.outcome_class,
         number(row.outcome.m_lr_over_m_total), ran ? c.settings : "no result",
         fmt::format("{}", c.runs), ran ? c.outcome_class : "-",
         ran ? fmt::format("{}", c.of_class) : "-", ran ? number(c.m_lr_over_m_total) : "-",
         c.runs > 1 ? number(c.m_lr_scatter) : "-", number(c.m_lr_difference(), "{:+.3f}")});
  }
  return text_table(table);
}

std::string summary(const std::vector<catalogue::Comparison>& all, const CatalogueArguments& a) {
  std::size_t lacking = 0, masses = 0, classes = 0, agreeing = 0;
  double squares = 0;
  for (const catalogue::Comparison& c : all) {
    if (c.runs == 0) ++lacking;
    if (const auto difference = c.m_lr_difference()) ++masses, squares += *difference * *difference;
    if (c.runs == 0 || !remnants::outcome_named(c.row->outcome.outcome_class)) continue;
    ++classes;
    if (c.row->outcome.outcome_class == c.outcome_class) ++agreeing;
  }
  std::string text;
  if (masses > 0)
    text += fmt::format("M_lr/M differs by {:.3f} (root mean square of {})\n",
                        std::sqrt(squares / static_cast<double>(masses)), masses);
  if (classes > 0) text += fmt::format("the class is the same in {} of {}\n", agreeing, classes);
  if (lacking > 0)
    text += fmt::format("{} impacts have no result; `eerie catalogue import {}` makes a sweep\n",
                        lacking, a.catalogue.string());
  return text;
}

int compare_catalogue(const CatalogueArguments& a) {
  if (!a.output.empty() && a.output.extension() != ".csv")
    throw InputError(fmt::format("-o {}: must be a .csv file", a.output.string()));
  const catalogue::Catalogue catalogue = load(a);
  const db::Connection connection(a.database, db::Access::read);
  const std::vector<catalogue::Comparison> all = catalogue::compare(connection, catalogue);
  if (!a.output.empty()) install(a.output, csv_of(all));
  if (a.json) {
    json list = json::array();
    for (const catalogue::Comparison& c : all) list.push_back(to_json(c));
    fmt::print("{}\n", list.dump(1));
  } else {
    fmt::print("{}\n{}", table_of(all), summary(all, a));
    if (!a.output.empty()) fmt::print("{}\n", a.output.string());
  }
  return static_cast<int>(ExitCode::done);
}

void add_reading(CLI::App& app, CatalogueArguments& a) {
  app.add_option("FILE", a.catalogue, "catalogue of collisions, CSV")->required();
  app.add_option("--density", a.options.density_kg_per_m3,
                 "kg/m^3, where the file does not say it (default: 2700)")
      ->check(CLI::Range(100.0, 20000.0));
  app.add_option("--radius", a.options.radius_m,
                 "radius of every target, m, in place of the file's: v/v_esc, mass ratio and "
                 "angle stay")
      ->check(CLI::Range(1e-3, 1e6));
}

}  // namespace

Action add_catalogue(CLI::App& app) {
  auto a = std::make_shared<CatalogueArguments>();
  app.require_subcommand(1);
  CLI::App* out = app.add_subcommand("export", "Write results as a catalogue of collisions");
  add_database(*out, a->database);
  add_filters(*out, a->filter);
  out->add_option("-o,--output", a->output, "write into this file (.csv)");
  CLI::App* in = app.add_subcommand("import", "Make a sweep file of a catalogue's impacts");
  add_reading(*in, *a);
  add_changes(*in, a->changes);
  in->add_option("-o,--output", a->output, "sweep file (default: named like the catalogue, .json)");
  add_json(*in, a->json);
  CLI::App* beside = app.add_subcommand("compare", "Print a catalogue's outcomes beside ours");
  add_reading(*beside, *a);
  add_database(*beside, a->database);
  beside->add_option("-o,--output", a->output, "write the comparison into this file too (.csv)");
  add_json(*beside, a->json);
  return [a, out, in] {
    return out->parsed()  ? export_catalogue(*a)
           : in->parsed() ? import_catalogue(*a)
                          : compare_catalogue(*a);
  };
}

}  // namespace eerie::cli
