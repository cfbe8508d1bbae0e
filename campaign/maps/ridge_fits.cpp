#include "campaign/maps/ridge_fits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "campaign/maps/map.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/error.hpp"

namespace eerie::maps {
using paper::RidgeRow;
using text::both, text::data, text::or_null, text::shown;
using text::Value;

std::vector<RidgeFit> fit_ridges(const ImpactRuns& runs,
                                 std::optional<std::int64_t> particles_per_target) {
  std::vector<RidgeFit> fits;
  for (ComparableRuns& group : groups_of(runs.runs)) {
    if (particles_per_target.value_or(group.settings.particles_per_target) !=
        group.settings.particles_per_target)
      continue;
    auto fit = paper::fit_threshold(paper::ridge_cells(group.runs));
    fits.push_back({std::move(group), std::move(fit)});
  }
  return fits;
}

text::Table table_of_rows(const paper::Threshold& t) {
  return text::table_of<RidgeRow>(
      {{both("theta_imp_deg", "theta deg", "{:g}"),
        [](const RidgeRow& r) { return r.theta_imp_deg; }},
       {both("speeds", "speeds"), [](const RidgeRow& r) { return r.speeds; }},
       {both("v_centre_cm_per_s", "centre cm/s", "{:.2f}"),
        [](const RidgeRow& r) { return r.v_centre; }},
       {both("v_sin_theta_cm_per_s", "v sin(theta)", "{:.2f}"),
        [](const RidgeRow& r) { return r.v_centre * std::sin(radians(r.theta_imp_deg)); }},
       {data("open"), [](const RidgeRow& r) { return r.open; }},
       {both("lowest_b_over_a", "least b/a", "{:.3f}"),
        [](const RidgeRow& r) { return r.lowest_b_over_a; }},
       {both("valley_cm_per_s", "at cm/s", "{:.2f}"),
        [](const RidgeRow& r) { return or_null(r.valley); }},
       {shown(""),
        [](const RidgeRow& r) { return r.open ? "open: sampled speeds end in EERs" : ""; }}},
      t.rows);
}

namespace {

Value to_json(const paper::RidgeBound& b) {
  return {
      {"low", b.low}, {"high", b.high}, {"below", or_null(b.below)}, {"above", or_null(b.above)}};
}

}  // namespace

nlohmann::json to_json(const RidgeFit& f) {
  const ComparableRuns& g = f.group;
  Value report = {{"q", g.q},
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
                 {"rows", text::records(table_of_rows(*t))}});
  return report;
}

std::string ridges_csv(const std::vector<RidgeFit>& fits) {
  std::string text =
      "q,phi_d_deg,particles_per_target,settings,runs,v_sin_theta_cm_per_s,low_cm_per_s,"
      "high_cm_per_s,half_width_cm_per_s,v_low_cm_per_s,v_high_cm_per_s,theta_low_deg,"
      "theta_high_deg,success,paper_cm_per_s\n";
  for (const RidgeFit& f : fits) {
    const ComparableRuns& g = f.group;
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

void draw_ridge(const std::filesystem::path& file, const db::Connection& connection,
                const std::vector<RidgeFit>& fits) {
  const auto count = std::ranges::count_if(fits, [](const RidgeFit& f) { return f.found(); });
  if (count != 1) {
    std::string choices;
    for (const RidgeFit& f : fits)
      if (f.found())
        choices += fmt::format("\n  --q {} --phi-d {} --settings {}   {}, {} particles", f.group.q,
                               f.group.phi_d_deg, f.group.settings.id, f.group.settings.name,
                               f.group.settings.particles_per_target);
    throw InputError(fmt::format(
        "-o {}: a figure needs one fitted ridge and there are {}; {}{}", file.string(), count,
        count == 0 ? "nothing to draw: give FILE.csv for what is known" : "choose one by",
        choices));
  }
  const RidgeFit& f = *std::ranges::find_if(fits, [](const RidgeFit& one) { return one.found(); });
  db::MapFilter filter;
  filter.q = f.group.q, filter.phi_d_deg = f.group.phi_d_deg;
  filter.settings = f.group.settings.id;
  diagrams::PhaseDiagram diagram = phase_diagrams(connection, filter).front();
  diagram.threshold_cm_per_s = f.found()->constant;
  diagram.threshold_source = "fitted";
  diagrams::draw_phase_diagram(file, diagram);
}

}  // namespace eerie::maps
