#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/output/files.hpp"
#include "campaign/maps/ridge_fits.hpp"
#include "campaign/maps/ridge_text.hpp"

namespace eerie::cli {
namespace {
using maps::RidgeFit;

struct ThresholdArguments {
  std::filesystem::path database;
  db::MapFilter filter;
  std::filesystem::path file;  ///< empty: none
};

Answer threshold(const ThresholdArguments& a) {
  const db::Connection connection(a.database, db::Access::read);
  db::ResultFilter filter;
  filter.q = a.filter.q, filter.phi_d_deg = a.filter.phi_d_deg;
  filter.fidelity = a.filter.fidelity, filter.settings = a.filter.settings;
  const maps::ImpactRuns runs = maps::impact_runs(connection, filter);
  const std::vector<RidgeFit> fits = maps::fit_ridges(runs, a.filter.particles_per_target);
  const std::string aside = maps::remark(runs);
  if (fits.empty())
    throw InputError(fmt::format("{}: holds no result with these parameters{}; {}",
                                 a.database.string(), aside.empty() ? "" : " (" + aside + ")",
                                 see_status(a.database)));
  if (a.file.extension() == ".csv") {
    install(a.file, maps::ridges_csv(fits));
  } else if (!a.file.empty()) {
    text::require_folder_of(a.file);
    maps::draw_ridge(a.file, connection, fits);
  }
  Answer answer;
  answer.data = {{"database", a.database.string()},
                 {"ridges", Value::array()},
                 {"unsettled", runs.unsettled},
                 {"left_out", {{"stale", runs.stale}, {"other_bodies", runs.other_bodies}}}};
  for (const RidgeFit& f : fits) {
    answer.data["ridges"].push_back(maps::to_json(f));
    answer.add_text(maps::ridge_text(f, fits) + "\n");
    if (!f.found()) continue;
    answer.add(maps::table_of_rows(*f.found()));
    answer.say("\n");
  }
  if (!aside.empty()) answer.say("{}\n", aside);
  if (a.file.empty()) return answer;
  answer.data["file"] = a.file.string();
  answer.add_files({a.file});
  return answer;
}

}  // namespace

Action add_threshold(CLI::App& app) {
  auto a = std::make_shared<ThresholdArguments>();
  add_database(app, a->database);
  add_map_filter(app, a->filter);
  app.add_option("-o,--output", a->file,
                 "the map with the fitted curve (.png, .svg, .pdf), or all constants (.csv)");
  add_formats(app);
  return [a](Output&) { return threshold(*a); };
}

}  // namespace eerie::cli
