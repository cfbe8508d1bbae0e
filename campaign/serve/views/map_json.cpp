#include "campaign/serve/views/map_json.hpp"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "analysis/diagrams/map_quantity.hpp"
#include "analysis/paper/threshold.hpp"
#include "analysis/remnants/outcome.hpp"
#include "analysis/statistics/ensemble.hpp"
#include "analysis/statistics/map_axis.hpp"
#include "campaign/maps/map.hpp"
#include "db/views/view.hpp"
#include "solver/base/error.hpp"

namespace eerie::serve {
using nlohmann::json;

namespace {

constexpr int colour_stops = 24;

json or_null(const std::optional<double>& value) { return value ? json(*value) : json(); }

/// [mean, standard deviation]
json to_json(const std::vector<double>& numbers) {
  const statistics::Ensemble e = statistics::ensemble(numbers);
  return {or_null(statistics::mean_of(e)), or_null(statistics::deviation_of(e))};
}

json to_json(const statistics::MapAxis& axis) { return {{"at", axis.at}, {"edges", axis.edges}}; }

json to_json(const diagrams::MapScale& scale) {
  json stops = json::array();
  for (int k = 0; k < colour_stops; ++k)
    stops.push_back(drawing::hex(scale.at_part(static_cast<double>(k) / (colour_stops - 1))));
  return {{"low", scale.low},
          {"high", scale.high},
          {"logarithmic", scale.logarithmic},
          {"ticks", scale.ticks},
          {"stops", std::move(stops)}};
}

const char* state_of(const diagrams::PhaseCell& cell, const db::MapPoint& p) {
  if (!p.running.empty()) return "running";
  if (cell.has_result()) return cell.state == diagrams::CellState::unsettled ? "unsettled" : "done";
  if (cell.state == diagrams::CellState::failed) return "failed";
  return p.cancelled == p.jobs ? "cancelled" : "pending";
}

json cell_json(const diagrams::PhaseCell& cell, const db::MapPoint& p,
               const std::vector<diagrams::MapScale>& scales) {
  json object = {
      {"v", p.v_imp_cm_per_s},      {"theta", p.theta_imp_deg}, {"v_over_v_esc", p.v_over_v_esc},
      {"state", state_of(cell, p)}, {"jobs", p.jobs},           {"done", p.done},
      {"failed", p.failed},         {"running", p.running},     {"results", p.results}};
  if (!cell.has_result()) return object;
  object.update({{"stale", p.stale},
                 {"unsettled", p.unsettled},
                 {"class", cell.outcome},
                 {"class_share", cell.class_share},
                 {"classes", p.classes},
                 {"smaller_eer", cell.smaller_eer},
                 {"is_eer", p.p_largest_eer() >= 0.5},
                 {"b_over_a", to_json(p.b_over_a)},
                 {"c_over_a", to_json(p.c_over_a)},
                 {"period_h", to_json(p.period_h)},
                 {"m_lr_over_m_total", to_json(p.m_lr_over_m_total)},
                 {"n_eer", to_json(p.n_eer)},
                 {"p_largest_eer", p.p_largest_eer()}});
  for (const diagrams::MapScale& scale : scales) {
    const std::string token(diagrams::name_of(scale.quantity).token);
    const auto value = diagrams::value_of(scale.quantity, cell);
    if (scale.quantity == diagrams::MapQuantity::outcome)
      object["colours"][token] = drawing::hex(diagrams::outcome_colour(cell.outcome));
    else if (value)
      object["colours"][token] = drawing::hex(scale.colour(*value)),
      object["words"][token] = diagrams::value_words(scale.quantity, *value);
  }
  return object;
}

json classes_json() {
  json classes = json::array();
  for (const remnants::OutcomeName& row : remnants::outcome_names)
    classes.push_back({{"name", row.name},
                       {"letter", row.short_name},
                       {"colour", drawing::hex(diagrams::outcome_colour(row.name))}});
  return classes;
}

/// The runs of a map by cell, stale ones left out. Of a run without a remnant b/a is 1, as in
/// `eerie threshold`; no scene is read, so that a hundred thousand runs cost a tenth of a second.
std::vector<paper::RidgeCell> ridge_cells(const db::Connection& connection,
                                          const db::MapFilter& filter, std::size_t& runs) {
  db::ViewQuery query{.view = db::View::results,
                      .columns = {"v_imp_cm_per_s", "theta_imp_deg", "b_over_a"},
                      .conditions = {{.column = "stale", .hi = 0}}};
  const auto is = [&](const char* column, std::optional<double> value) {
    if (value) query.conditions.push_back({.column = column, .lo = value, .hi = value});
  };
  is("q", filter.q), is("phi_d_deg", filter.phi_d_deg);
  if (filter.settings) is("settings", static_cast<double>(*filter.settings));
  std::vector<paper::RidgeCell> cells;
  db::each_row(connection, query, [&](SQLite::Statement& row) {
    const double v = row.getColumn(0).getDouble(), theta = row.getColumn(1).getDouble();
    // Rows come by speed and angle.
    if (cells.empty() || cells.back().v_imp_cm_per_s != v || cells.back().theta_imp_deg != theta)
      cells.push_back({v, theta, {}});
    cells.back().b_over_a.push_back(row.getColumn(2).isNull() ? 1 : row.getColumn(2).getDouble());
    ++runs;
  });
  return cells;
}

/// Without gnuplot's markup.
std::string plain(std::string_view title) {
  std::string text;
  for (const char c : title)
    if (c != '{' && c != '}' && c != '_') text += c;
  return text;
}

json quantities_json(const std::vector<diagrams::MapScale>& scales) {
  json list = json::array();
  for (const diagrams::MapScale& scale : scales) {
    const diagrams::QuantityName& row = diagrams::name_of(scale.quantity);
    list.push_back(
        {{"token", row.token}, {"title", plain(row.title.text)}, {"scale", to_json(scale)}});
  }
  return list;
}

}  // namespace

json map_names_json(const db::Connection& connection) {
  json maps = json::array();
  for (const db::MapName& m : db::map_names(connection))
    maps.push_back({{"q", m.q},
                    {"phi_d_deg", m.phi_d_deg},
                    {"particles_per_target", m.particles_per_target},
                    {"settings", m.settings},
                    {"fidelity", m.fidelity},
                    {"jobs", m.jobs},
                    {"done", m.done}});
  return {{"maps", std::move(maps)}};
}

json map_json(const db::Connection& connection, const db::MapFilter& filter) {
  const std::vector<db::MapPoint> points = db::map_points(connection, filter);
  const std::vector<diagrams::PhaseDiagram> found = maps::phase_diagrams(points);
  if (found.size() != 1)
    throw InputError(fmt::format(
        "q, phi_d and settings choose one map, and these leave {}; /api/maps lists them",
        found.size()));
  const diagrams::PhaseDiagram& d = found.front();
  std::vector<diagrams::MapScale> scales;
  for (const diagrams::QuantityName& row : diagrams::quantity_names)
    scales.push_back(diagrams::map_scale(row.quantity, d.cells));
  std::vector<double> speeds, angles;
  json cells = json::array();
  for (std::size_t k = 0; k < points.size(); ++k) {
    speeds.push_back(points[k].v_imp_cm_per_s), angles.push_back(points[k].theta_imp_deg);
    cells.push_back(cell_json(d.cells[k], points[k], scales));
  }
  return {{"q", d.q},
          {"phi_d_deg", d.phi_d_deg},
          {"particles_per_target", d.particles_per_target},
          {"settings", d.settings},
          {"fidelity", d.fidelity},
          {"v_esc_cm_per_s", d.v_esc_cm_per_s},
          {"paper_cm_per_s", or_null(d.threshold_cm_per_s)},
          {"v", to_json(statistics::map_axis(std::move(speeds)))},
          {"theta", to_json(statistics::map_axis(std::move(angles)))},
          {"quantities", quantities_json(scales)},
          {"classes", classes_json()},
          {"cells", std::move(cells)}};
}

json ridge_json(const db::Connection& connection, const db::MapFilter& filter) {
  std::size_t runs = 0;
  const std::vector<paper::RidgeCell> cells = ridge_cells(connection, filter, runs);
  // The interval of a map of very many runs is narrow, and told well enough by fewer samples.
  constexpr std::size_t draws = 20'000'000, most = 2000, fewest = 200;
  const auto fit =
      paper::fit_threshold(cells, std::clamp(draws / std::max<std::size_t>(runs, 1), fewest, most));
  const auto* t = std::get_if<paper::Threshold>(&fit);
  if (t == nullptr) return {{"reason", std::get<paper::TooFewForThreshold>(fit).reason}};
  return {{"constant", t->constant},
          {"low", t->low},
          {"high", t->high},
          {"half_width", t->half_width()},
          {"runs", runs}};
}

}  // namespace eerie::serve
