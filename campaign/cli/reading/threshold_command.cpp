#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/output/files.hpp"
#include "campaign/maps/ridge_fits.hpp"

namespace eerie::cli {
namespace {
using maps::RidgeFit;

struct ThresholdArguments {
  std::filesystem::path database;
  db::MapFilter filter;
  std::filesystem::path file;  ///< empty: none
};

std::string title(const maps::ComparableRuns& g) {
  return fmt::format(
      "q = {:g}, phi_d = {:g} deg, {} ({} particles per target), {} runs of {} impacts", g.q,
      g.phi_d_deg, g.settings.name, g.settings.particles_per_target, g.runs.size(),
      paper::ridge_cells(g.runs).size());
}

/// What tells a group from others of its name: ", settings 3".
std::string distinction(const maps::ComparableRuns& g, const std::vector<RidgeFit>& all) {
  const bool alone =
      std::ranges::count_if(all, [&](const RidgeFit& f) {
        return f.group.q == g.q && f.group.phi_d_deg == g.phi_d_deg &&
               f.group.settings.name == g.settings.name &&
               f.group.settings.particles_per_target == g.settings.particles_per_target;
      }) == 1;
  return alone ? "" : fmt::format(", settings {}", g.settings.id);
}

/// "12.5 to 17.5 deg (10 and 20: none)".
std::string bound_text(const paper::RidgeBound& b, const char* unit) {
  const auto next = [](const std::optional<double>& value) {
    return value ? fmt::format("none at {:g}", *value) : std::string("not sampled");
  };
  return fmt::format("{:g} to {:g} {} (below: {}; above: {})", b.low, b.high, unit, next(b.below),
                     next(b.above));
}

void add_constants(Answer& answer, const paper::Threshold& t, const std::optional<double>& paper) {
  answer.say("  v sin(theta) = {:.2f} cm/s, 95 %: {:.2f} to {:.2f}", t.constant, t.low, t.high);
  if (paper)
    answer.say("; paper {:g}, {:+.2f} ({} the interval)", *paper, t.constant - *paper,
               t.low <= *paper && *paper <= t.high ? "inside" : "outside");
  answer.say(
      "\n  EERs at v = {}\n          theta = {}\n  band +- {:.2f} cm/s: {:.0f} % of the runs that "
      "are EERs or in it are both\n",
      bound_text(t.v_imp, "cm/s"), bound_text(t.theta_imp, "deg"), t.half_width(), 100 * t.success);
  if (t.valley)
    answer.say("  least b/a along {} angle{}: v sin(theta) = {:.2f} cm/s\n", t.valley_rows,
               t.valley_rows == 1 ? "" : "s", *t.valley);
  if (t.scatter_s)
    answer.say("  centres of rows scatter by {:.0f} % in v sin(theta), {:.0f} % in v alone\n",
               100 * *t.scatter_s, 100 * *t.scatter_v);
  else
    answer.say(
        "  fewer than two angles have EERs with both sides sampled: whether v sin(theta) is the "
        "same at all angles is not known\n");
}

void add_ridge(Answer& answer, const RidgeFit& f, const std::vector<RidgeFit>& all) {
  answer.say("{}{}\n", title(f.group), distinction(f.group, all));
  if (const paper::Threshold* t = f.found()) {
    add_constants(answer, *t, paper::published_threshold(f.group.q, f.group.phi_d_deg));
    answer.say("\n");
    answer.add(maps::table_of_rows(*t));
  } else {
    answer.say("  not enough data: {}\n", std::get<paper::TooFewForThreshold>(f.fit).reason);
  }
  answer.say("\n");
}

Answer threshold(const ThresholdArguments& a) {
  const db::Connection connection(a.database, db::Access::read);
  db::ResultFilter filter;
  filter.q = a.filter.q, filter.phi_d_deg = a.filter.phi_d_deg;
  filter.fidelity = a.filter.fidelity, filter.settings = a.filter.settings;
  const maps::ImpactRuns runs = maps::impact_runs(connection, filter);
  const std::vector<RidgeFit> fits = maps::fit_ridges(runs, a.filter.particles_per_target);
  const std::string aside = maps::remark(runs);
  if (fits.empty())
    throw InputError(fmt::format(
        "{}: holds no result with these parameters{}; `eerie status --db {}` shows what it "
        "holds",
        a.database.string(), aside.empty() ? "" : " (" + aside + ")", a.database.string()));
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
    add_ridge(answer, f, fits);
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
