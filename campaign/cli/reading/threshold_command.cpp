#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/output/text_table.hpp"
#include "campaign/cli/output/files.hpp"
#include "campaign/maps/impact_runs.hpp"
#include "campaign/maps/map.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"

namespace eerie::cli {
namespace {
namespace fs = std::filesystem;
using nlohmann::json;

struct ThresholdArguments {
  fs::path database;
  db::MapFilter filter;
  fs::path file;  ///< empty: none
  bool json = false;
};

/// A group of runs and what the fit says of it.
struct Fitted {
  const maps::ComparableRuns* group = nullptr;
  std::variant<paper::Threshold, paper::TooFewForThreshold> fit;
  const paper::Threshold* found() const { return std::get_if<paper::Threshold>(&fit); }
};

json or_null(const std::optional<double>& value) { return value ? json(*value) : json(); }

json to_json(const paper::RidgeBound& b) {
  return {
      {"low", b.low}, {"high", b.high}, {"below", or_null(b.below)}, {"above", or_null(b.above)}};
}

json to_json(const paper::RidgeRow& row) {
  return {{"theta_imp_deg", row.theta_imp_deg},
          {"speeds", row.speeds},
          {"v_centre_cm_per_s", row.v_centre},
          {"v_sin_theta_cm_per_s", row.v_centre * std::sin(radians(row.theta_imp_deg))},
          {"open", row.open},
          {"lowest_b_over_a", row.lowest_b_over_a},
          {"valley_cm_per_s", or_null(row.valley)}};
}

json to_json(const Fitted& f) {
  const maps::ComparableRuns& g = *f.group;
  json report = {{"q", g.q},
                 {"phi_d_deg", g.phi_d_deg},
                 {"particles_per_target", g.settings.particles_per_target},
                 {"settings", g.settings.name},
                 {"settings_number", g.settings.id},
                 {"runs", g.runs.size()},
                 {"impacts", paper::ridge_cells(g.runs).size()},
                 {"paper_cm_per_s", or_null(paper::published_threshold(g.q, g.phi_d_deg))}};
  const paper::Threshold* t = f.found();
  if (t == nullptr) {
    report["not_enough_data"] = std::get<paper::TooFewForThreshold>(f.fit).reason;
    return report;
  }
  report.update({{"v_sin_theta_cm_per_s", t->constant},
                 {"low_cm_per_s", t->low},
                 {"high_cm_per_s", t->high},
                 {"half_width_cm_per_s", t->half_width()},
                 {"v_imp_cm_per_s", to_json(t->v_imp)},
                 {"theta_imp_deg", to_json(t->theta_imp)},
                 {"success", t->success},
                 {"valley_cm_per_s", or_null(t->valley)},
                 {"valley_rows", t->valley_rows},
                 {"scatter_of_v_sin_theta", or_null(t->scatter_s)},
                 {"scatter_of_v", or_null(t->scatter_v)},
                 {"rows", json::array()}});
  for (const paper::RidgeRow& row : t->rows) report["rows"].push_back(to_json(row));
  return report;
}

std::string title(const maps::ComparableRuns& g) {
  return fmt::format(
      "q = {:g}, phi_d = {:g} deg, {} ({} particles per target), {} runs of {} impacts", g.q,
      g.phi_d_deg, g.settings.name, g.settings.particles_per_target, g.runs.size(),
      paper::ridge_cells(g.runs).size());
}

/// What tells a group from others of its name: ", settings 3".
std::string distinction(const maps::ComparableRuns& g, const std::vector<Fitted>& all) {
  const bool alone =
      std::ranges::count_if(all, [&](const Fitted& f) {
        return f.group->q == g.q && f.group->phi_d_deg == g.phi_d_deg &&
               f.group->settings.name == g.settings.name &&
               f.group->settings.particles_per_target == g.settings.particles_per_target;
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

std::string rows_table(const paper::Threshold& t) {
  std::vector<std::vector<std::string>> rows = {
      {"theta deg", "speeds", "centre cm/s", "v sin(theta)", "least b/a", "at cm/s", ""}};
  for (const paper::RidgeRow& row : t.rows)
    rows.push_back({fmt::format("{:g}", row.theta_imp_deg), fmt::format("{}", row.speeds),
                    fmt::format("{:.2f}", row.v_centre),
                    fmt::format("{:.2f}", row.v_centre * std::sin(radians(row.theta_imp_deg))),
                    fmt::format("{:.3f}", row.lowest_b_over_a),
                    row.valley ? fmt::format("{:.2f}", *row.valley) : "-",
                    row.open ? "open: sampled speeds end in EERs" : ""});
  return text_table(rows);
}

std::string text_of(const Fitted& f, const std::vector<Fitted>& all) {
  std::string text = title(*f.group) + distinction(*f.group, all) + "\n";
  const paper::Threshold* t = f.found();
  if (t == nullptr)
    return text + "  not enough data: " + std::get<paper::TooFewForThreshold>(f.fit).reason + "\n";
  text += fmt::format("  v sin(theta) = {:.2f} cm/s, 95 %: {:.2f} to {:.2f}", t->constant, t->low,
                      t->high);
  if (const auto paper = paper::published_threshold(f.group->q, f.group->phi_d_deg))
    text += fmt::format("; paper {:g}, {:+.2f} ({} the interval)", *paper, t->constant - *paper,
                        t->low <= *paper && *paper <= t->high ? "inside" : "outside");
  text += fmt::format(
      "\n  EERs at v = {}\n          theta = {}\n  band +- {:.2f} cm/s: {:.0f} % of the runs that "
      "are "
      "EERs or in it are both\n",
      bound_text(t->v_imp, "cm/s"), bound_text(t->theta_imp, "deg"), t->half_width(),
      100 * t->success);
  if (t->valley)
    text += fmt::format("  least b/a along {} angle{}: v sin(theta) = {:.2f} cm/s\n",
                        t->valley_rows, t->valley_rows == 1 ? "" : "s", *t->valley);
  if (t->scatter_s)
    text +=
        fmt::format("  centres of rows scatter by {:.0f} % in v sin(theta), {:.0f} % in v alone\n",
                    100 * *t->scatter_s, 100 * *t->scatter_v);
  else
    text +=
        "  fewer than two angles have EERs with both sides sampled: whether v sin(theta) is the "
        "same at all angles is not known\n";
  return text + "\n" + rows_table(*t);
}

std::string csv_of(const std::vector<Fitted>& fits) {
  std::string text =
      "q,phi_d_deg,particles_per_target,settings,runs,v_sin_theta_cm_per_s,low_cm_per_s,"
      "high_cm_per_s,half_width_cm_per_s,v_low_cm_per_s,v_high_cm_per_s,theta_low_deg,"
      "theta_high_deg,success,paper_cm_per_s\n";
  for (const Fitted& f : fits) {
    const maps::ComparableRuns& g = *f.group;
    text += fmt::format("{},{},{},{},{},", g.q, g.phi_d_deg, g.settings.particles_per_target,
                        g.settings.name, g.runs.size());
    if (const paper::Threshold* t = f.found())
      text += fmt::format("{:.4f},{:.4f},{:.4f},{:.4f},{},{},{},{},{:.4f},", t->constant, t->low,
                          t->high, t->half_width(), t->v_imp.low, t->v_imp.high, t->theta_imp.low,
                          t->theta_imp.high, t->success);
    else
      text += ",,,,,,,,,";
    const auto paper = paper::published_threshold(g.q, g.phi_d_deg);
    text += paper ? fmt::format("{}\n", *paper) : "\n";
  }
  return text;
}

/// The map with the fitted curve in place of the paper's.
void draw(const ThresholdArguments& a, const db::Connection& connection,
          const std::vector<Fitted>& fits) {
  const auto count = std::ranges::count_if(fits, [](const Fitted& f) { return f.found(); });
  if (count != 1) {
    std::string choices;
    for (const Fitted& f : fits)
      if (f.found())
        choices += fmt::format("\n  --q {} --phi-d {} --settings {}   {}, {} particles", f.group->q,
                               f.group->phi_d_deg, f.group->settings.id, f.group->settings.name,
                               f.group->settings.particles_per_target);
    throw InputError(fmt::format(
        "-o {}: a figure needs one fitted ridge and there are {}; {}{}", a.file.string(), count,
        count == 0 ? "nothing to draw: give FILE.csv for what is known" : "choose one by",
        choices));
  }
  const Fitted& f = *std::ranges::find_if(fits, [](const Fitted& one) { return one.found(); });
  db::MapFilter filter;
  filter.q = f.group->q, filter.phi_d_deg = f.group->phi_d_deg;
  filter.settings = f.group->settings.id;
  diagrams::PhaseDiagram diagram = maps::phase_diagrams(connection, filter).front();
  diagram.threshold_cm_per_s = f.found()->constant;
  diagrams::draw_phase_diagram(a.file, diagram);
}

int threshold(const ThresholdArguments& a) {
  const bool table = a.file.extension() == ".csv";
  const db::Connection connection(a.database, db::Access::read);
  db::ResultFilter filter;
  filter.q = a.filter.q, filter.phi_d_deg = a.filter.phi_d_deg;
  filter.fidelity = a.filter.fidelity, filter.settings = a.filter.settings;
  const maps::ImpactRuns runs = maps::impact_runs(connection, filter);
  const std::vector<maps::ComparableRuns> groups = maps::groups_of(runs.runs);
  std::vector<Fitted> fits;
  for (const maps::ComparableRuns& group : groups)
    if (a.filter.particles_per_target.value_or(group.settings.particles_per_target) ==
        group.settings.particles_per_target)
      fits.push_back({&group, paper::fit_threshold(paper::ridge_cells(group.runs))});
  const std::string aside = maps::remark(runs);
  if (fits.empty())
    throw InputError(fmt::format(
        "{}: holds no result with these parameters{}; `eerie status --db {}` shows what it "
        "holds",
        a.database.string(), aside.empty() ? "" : " (" + aside + ")", a.database.string()));
  if (!a.file.empty()) {
    make_folder_of(a.file);
    if (table)
      install_text(a.file, csv_of(fits));
    else
      draw(a, connection, fits);
  }
  if (a.json) {
    json report = {{"database", a.database.string()}, {"ridges", json::array()}};
    for (const Fitted& f : fits) report["ridges"].push_back(to_json(f));
    report["unsettled"] = runs.unsettled;
    report["left_out"] = {{"stale", runs.stale}, {"other_bodies", runs.other_bodies}};
    if (!a.file.empty()) report["file"] = a.file.string();
    fmt::print("{}\n", report.dump(1));
    return static_cast<int>(ExitCode::done);
  }
  for (const Fitted& f : fits) fmt::print("{}\n", text_of(f, fits));
  if (!aside.empty()) fmt::print("{}\n", aside);
  if (!a.file.empty()) fmt::print("{}\n", a.file.string());
  return static_cast<int>(ExitCode::done);
}

}  // namespace

Action add_threshold(CLI::App& app) {
  auto a = std::make_shared<ThresholdArguments>();
  add_database(app, a->database);
  add_map_filter(app, a->filter);
  app.add_option("-o,--output", a->file,
                 "the map with the fitted curve (.png, .svg, .pdf), or all constants (.csv)");
  add_json(app, a->json);
  return [a] { return threshold(*a); };
}

}  // namespace eerie::cli
