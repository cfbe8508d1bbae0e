#include "campaign/catalogue/catalogue_export.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "campaign/catalogue/quantities.hpp"
#include "campaign/text/csv.hpp"
#include "db/jobs/jobs.hpp"
#include "db/views/query.hpp"
#include "solver/scene/scene.hpp"
#include "solver/scene/two_materials.hpp"

namespace eerie::catalogue {
namespace {

/// A result with its scene, for the fields of a line.
struct Line {
  const db::ResultRow& row;
  const Scene& scene;
  double total_kg() const { return target_mass(scene) * (1 + scene.impact.q); }
};

std::string number(std::optional<double> value) { return value ? fmt::format("{}", *value) : ""; }
std::string mass(double kg) { return fmt::format("{:.9g}", kg); }

/// A column: a known quantity under its name, or one that only eerie has.
struct Column {
  std::string name;
  std::string (*text)(const Line&);
};

const std::vector<Column>& columns() {
  using enum CatalogueQuantity;
  static const std::vector<Column> all = {
      {column_name(run_id), [](const Line& l) { return l.row.hash.substr(0, 16); }},
      {column_name(v_imp), [](const Line& l) { return moved(l.row.v_imp_cm_per_s, -2); }},
      {column_name(v_imp_over_v_esc),
       [](const Line& l) { return fmt::format("{:.6g}", l.row.v_over_v_esc); }},
      {column_name(theta_imp), [](const Line& l) { return number(l.row.theta_imp_deg); }},
      {column_name(m_target), [](const Line& l) { return mass(target_mass(l.scene)); }},
      {column_name(m_projectile),
       [](const Line& l) { return mass(target_mass(l.scene) * l.scene.impact.q); }},
      {column_name(m_lr),
       [](const Line& l) { return mass(l.row.result.m_lr_over_m_total * l.total_kg()); }},
      {column_name(m_slr),
       [](const Line& l) { return mass(l.row.result.m_slr_over_m_total * l.total_kg()); }},
      {column_name(outcome_class), [](const Line& l) { return l.row.result.outcome_class; }},
      {column_name(b_over_a), [](const Line& l) { return number(l.row.result.b_over_a); }},
      {"c_over_a", [](const Line& l) { return number(l.row.result.c_over_a); }},
      {"period_h", [](const Line& l) { return number(l.row.result.period_h); }},
      {"settled", [](const Line& l) { return std::string(l.row.result.settled ? "1" : "0"); }},
      {column_name(q), [](const Line& l) { return number(l.scene.impact.q); }},
      {column_name(r_target), [](const Line& l) { return number(l.scene.target.radius_m); }},
      {column_name(rho), [](const Line& l) { return number(l.scene.material.rho0_kg_per_m3); }},
      {column_name(phi_d), [](const Line& l) { return number(l.row.phi_d_deg); }},
      {"particles_per_target",
       [](const Line& l) { return fmt::format("{}", l.row.particles_per_target); }},
      {column_name(seed), [](const Line& l) { return fmt::format("{}", l.row.seed); }},
      {column_name(fidelity), [](const Line& l) { return l.row.fidelity; }},
  };
  return all;
}

}  // namespace

std::string catalogue_csv(const db::Connection& connection, const db::ViewQuery& query) {
  std::string text;
  for (const Column& column : columns()) text += (text.empty() ? "" : ",") + column.name;
  text += "\n";
  for (const db::ResultRow& row : db::selected_results(connection, query)) {
    // A scene of another version of the program may lack fields: defaults fill them in.
    const Scene scene = parse_scene(nlohmann::json::parse(db::scene(connection, row.job)));
    if (has_two_materials(scene)) continue;  // a catalogue has one density for both bodies
    const Line line{row, scene};
    std::string fields;
    for (const Column& column : columns())
      fields += (fields.empty() ? "" : ",") + text::csv_field(column.text(line));
    text += fields + "\n";
  }
  return text;
}

}  // namespace eerie::catalogue
