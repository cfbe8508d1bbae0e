#include "campaign/serve/map_json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "analysis/map_axis.hpp"
#include "analysis/map_quantity.hpp"
#include "analysis/outcome.hpp"
#include "campaign/impact_runs.hpp"
#include "campaign/map.hpp"
#include "solver/base/error.hpp"

namespace eerie::serve {
using nlohmann::json;

namespace {

constexpr int colour_stops = 24;

json or_null(const std::optional<double>& value) { return value ? json(*value) : json(); }

/// [mean, standard deviation]
json to_json(const db::Spread& s) { return {or_null(s.mean), or_null(s.std_dev)}; }

json to_json(const MapAxis& axis) { return {{"at", axis.at}, {"edges", axis.edges}}; }

json to_json(const MapScale& scale) {
  json stops = json::array();
  for (int k = 0; k < colour_stops; ++k)
    stops.push_back(hex(scale.at_part(static_cast<double>(k) / (colour_stops - 1))));
  return {{"low", scale.low},
          {"high", scale.high},
          {"logarithmic", scale.logarithmic},
          {"ticks", scale.ticks},
          {"stops", std::move(stops)}};
}

const char* state_of(const PhaseCell& cell, const db::MapPoint& p) {
  if (!p.running.empty()) return "running";
  if (cell.has_result()) return cell.state == CellState::unsettled ? "unsettled" : "done";
  if (cell.state == CellState::failed) return "failed";
  return p.cancelled == p.jobs ? "cancelled" : "pending";
}

json cell_json(const PhaseCell& cell, const db::MapPoint& p, const std::vector<MapScale>& scales) {
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
                 {"is_eer", p.p_eer() >= 0.5},
                 {"b_over_a", to_json(p.b_over_a)},
                 {"c_over_a", to_json(p.c_over_a)},
                 {"period_h", to_json(p.period_h)},
                 {"m_lr_over_m_total", to_json(p.m_lr_over_m_total)},
                 {"n_eer", to_json(p.n_eer)},
                 {"p_eer", p.p_eer()}});
  for (const MapScale& scale : scales) {
    const std::string token(name_of(scale.quantity).token);
    const auto value = value_of(scale.quantity, cell);
    if (scale.quantity == MapQuantity::outcome)
      object["colours"][token] = hex(outcome_colour(cell.outcome));
    else if (value)
      object["colours"][token] = hex(scale.colour(*value)),
      object["words"][token] = value_words(scale.quantity, *value);
  }
  return object;
}

json classes_json() {
  json classes = json::array();
  for (const OutcomeName& row : outcome_names)
    classes.push_back({{"name", row.name},
                       {"letter", row.short_name},
                       {"colour", hex(outcome_colour(row.name))}});
  return classes;
}

/// Without gnuplot's markup.
std::string plain(std::string_view title) {
  std::string text;
  for (const char c : title)
    if (c != '{' && c != '}' && c != '_') text += c;
  return text;
}

json quantities_json(const std::vector<MapScale>& scales) {
  json list = json::array();
  for (const MapScale& scale : scales) {
    const QuantityName& row = name_of(scale.quantity);
    list.push_back({{"token", row.token}, {"title", plain(row.title)}, {"scale", to_json(scale)}});
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
  const std::vector<PhaseDiagram> diagrams = phase_diagrams(points);
  if (diagrams.size() != 1)
    throw InputError(fmt::format(
        "q, phi_d and settings choose one map, and these leave {}; /api/maps lists them",
        diagrams.size()));
  const PhaseDiagram& d = diagrams.front();
  std::vector<MapScale> scales;
  for (const QuantityName& row : quantity_names) scales.push_back(map_scale(row.quantity, d.cells));
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
          {"v", to_json(map_axis(std::move(speeds)))},
          {"theta", to_json(map_axis(std::move(angles)))},
          {"quantities", quantities_json(scales)},
          {"classes", classes_json()},
          {"cells", std::move(cells)}};
}

json ridge_json(const db::Connection& connection, const db::MapFilter& filter) {
  const db::ResultFilter of_map{
      .q = filter.q, .phi_d_deg = filter.phi_d_deg, .settings = filter.settings};
  const ImpactRuns runs = impact_runs(connection, of_map);
  const std::vector<RunGroup> groups = groups_of(runs.runs);
  if (groups.size() != 1) return {{"reason", "no runs of the paper's bodies: nothing is fitted"}};
  const auto fit = fit_threshold(ridge_cells(groups.front().runs));
  const auto* t = std::get_if<Threshold>(&fit);
  if (t == nullptr) return {{"reason", std::get<TooFewForThreshold>(fit).reason}};
  return {{"constant", t->constant},
          {"low", t->low},
          {"high", t->high},
          {"half_width", t->half_width()},
          {"runs", groups.front().runs.size()}};
}

}  // namespace eerie::serve
