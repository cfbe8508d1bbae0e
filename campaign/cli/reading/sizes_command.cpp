#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "analysis/drawing/gnuplot.hpp"
#include "analysis/figures/size_distribution.hpp"
#include "analysis/remnants/remnants.hpp"
#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/options/filters.hpp"
#include "campaign/cli/output/text_table.hpp"
#include "campaign/cli/output/files.hpp"
#include "campaign/text/csv.hpp"
#include "db/views/query.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"

namespace eerie::cli {
namespace {
namespace fs = std::filesystem;
using nlohmann::json;

struct SizesArguments {
  fs::path database;
  FilterArguments filter;
  std::vector<fs::path> files;
  bool json = false;
};

/// Of the impacts that the filter leaves, those of one particle number and settings together.
std::vector<figures::SizeDistribution> distributions(const db::Connection& connection,
                                                     const FilterArguments& filter) {
  std::map<std::int64_t, std::vector<double>> masses;  // by job
  const db::ViewQuery all{.view = db::View::remnants, .columns = {"job", "mass_over_total"}};
  for (const auto& row : db::rows(connection, all).rows)
    masses[std::get<std::int64_t>(row[0])].push_back(std::get<double>(row[1]));
  std::map<std::pair<std::int64_t, std::string>, figures::SizeDistribution> found;
  for (const db::ResultRow& row :
       db::selected_results(connection, filtered(connection, db::View::results, filter))) {
    figures::SizeDistribution& d = found[{row.particles_per_target, row.fidelity}];
    d.name = row.fidelity.empty() ? "no named settings" : row.fidelity;
    d.particles_per_target = row.particles_per_target;
    ++d.impacts;
    d.limit = std::max(d.limit, static_cast<double>(remnants::remnant_min_particles) /
                                    (static_cast<double>(row.particles_per_target) * (1 + row.q)));
    if (const auto of_job = masses.find(row.job); of_job != masses.end())
      d.masses.insert(d.masses.end(), of_job->second.begin(), of_job->second.end());
  }
  std::vector<figures::SizeDistribution> list;
  for (auto& [key, d] : found) {
    std::ranges::sort(d.masses, std::greater());
    list.push_back(std::move(d));
  }
  return list;
}

std::string csv_of(const std::vector<figures::SizeDistribution>& all) {
  std::string text =
      "settings,particles_per_target,impacts,mass_over_total,remnants_per_impact,"
      "limit_over_total\n";
  for (const figures::SizeDistribution& d : all)
    for (const figures::SizeStep& step : figures::steps(d))
      text += fmt::format("{},{},{},{},{},{}\n", text::csv_field(d.name), d.particles_per_target,
                          d.impacts, step.mass, step.count, d.limit);
  return text;
}

/// At round masses down to the finest limit; "-" below that of a column.
std::string table_of(const std::vector<figures::SizeDistribution>& all) {
  std::vector<std::vector<std::string>> table = {{"m/M at least"}};
  double finest = 1;
  for (const figures::SizeDistribution& d : all) {
    table[0].push_back(fmt::format("{} ({})", d.name, d.particles_per_target));
    finest = std::min(finest, d.limit);
  }
  std::vector<double> masses = {0.9};
  for (double decade = 1; decade > finest / 10; decade /= 10)
    for (const double part : {0.5, 0.2, 0.1})
      if (part * decade >= finest * (1 - 1e-9)) masses.push_back(part * decade);
  for (const double mass : masses) {
    std::vector<std::string>& line = table.emplace_back();
    line.push_back(fmt::format("{:g}", mass));
    for (const figures::SizeDistribution& d : all)
      line.push_back(mass < d.limit * (1 - 1e-9) ? "-" : fmt::format("{:.3f}", d.count_from(mass)));
  }
  return text_table(table);
}

std::string text_of(const std::vector<figures::SizeDistribution>& all) {
  std::string text;
  for (const figures::SizeDistribution& d : all)
    text += fmt::format(
        "{} ({} particles per target): {} remnants of at least {} particles (m/M = {:.3g}) in {} "
        "impact{}\n",
        d.name, d.particles_per_target, d.masses.size(), remnants::remnant_min_particles, d.limit,
        d.impacts, d.impacts == 1 ? "" : "s");
  return text + "\nremnants per impact\n" + table_of(all);
}

json json_of(const std::vector<figures::SizeDistribution>& all) {
  json list = json::array();
  for (const figures::SizeDistribution& d : all)
    list.push_back({{"settings", d.name},
                    {"particles_per_target", d.particles_per_target},
                    {"impacts", d.impacts},
                    {"limit_over_total", d.limit},
                    {"mass_over_total", d.masses}});
  return {{"distributions", std::move(list)}};
}

int sizes(const SizesArguments& a) {
  for (const fs::path& file : a.files)
    if (file.extension() != ".csv") drawing::gnuplot_terminal(file, 1, 1);  // throws for no format
  const db::Connection connection(a.database, db::Access::read);
  const std::vector<figures::SizeDistribution> all = distributions(connection, a.filter);
  if (all.empty())
    throw InputError(
        fmt::format("{}: no result matches; `eerie status --db {}` shows what it holds",
                    a.database.string(), a.database.string()));
  for (const fs::path& file : a.files) {
    make_folder_of(file);
    if (file.extension() == ".csv")
      install_text(file, csv_of(all));
    else
      figures::draw_sizes(file, all);
  }
  if (a.json) {
    fmt::print("{}\n", json_of(all).dump(1));
    return static_cast<int>(ExitCode::done);
  }
  fmt::print("{}", text_of(all));
  for (const fs::path& file : a.files) fmt::print("{}\n", file.string());
  return static_cast<int>(ExitCode::done);
}

}  // namespace

Action add_sizes(CLI::App& app) {
  auto a = std::make_shared<SizesArguments>();
  add_database(app, a->database);
  add_filters(app, a->filter);
  app.add_option("-o,--output", a->files,
                 "figure (.svg, .png, .pdf) or every step (.csv); may be repeated")
      ->allow_extra_args(false);
  add_json(app, a->json);
  return [a] { return sizes(*a); };
}

}  // namespace eerie::cli
