#include "campaign/catalogue/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "analysis/paper/impact_run.hpp"
#include "analysis/remnants/outcome.hpp"
#include "analysis/statistics/ensemble.hpp"
#include "db/jobs/jobs.hpp"
#include "db/views/query.hpp"
#include "db/views/view.hpp"
#include "solver/scene/scene.hpp"
#include "solver/scene/two_materials.hpp"

namespace eerie::catalogue {
using text::both, text::data, text::or_null, text::shown;
using text::Column, text::Field, text::Value;

namespace {

constexpr double same_bodies = 1e-6;  // relative, in radius and density

bool close(double a, double b) { return std::abs(a - b) <= same_bodies * std::abs(b); }

db::Condition near(const char* column, double value, double tolerance) {
  return {.column = column, .lo = value - tolerance, .hi = value + tolerance};
}

db::ViewQuery at_point_of(const CatalogueImpact& impact) {
  db::ViewQuery query;
  query.conditions = {near("v_imp_cm_per_s", impact.v_imp_cm_per_s, paper::same_v_cm_per_s),
                      near("theta_imp_deg", impact.theta_imp_deg, paper::same_theta_deg),
                      near("q", impact.q, paper::same_q),
                      {.column = "stale", .hi = 0}};
  if (impact.phi_d_deg)
    query.conditions.push_back(near("phi_d_deg", *impact.phi_d_deg, paper::same_phi_d_deg));
  return query;
}

/// Sums over the runs of one settings.
struct Tally {
  std::vector<double> m_lr;
  double m_slr = 0;
  std::vector<double> b_over_a;
  std::map<std::string, std::size_t> classes;

  void add(const db::Result& r) {
    m_lr.push_back(r.m_lr_over_m_total);
    m_slr += r.m_slr_over_m_total;
    ++classes[r.outcome_class];
    if (r.b_over_a) b_over_a.push_back(*r.b_over_a);
  }
  void finish(Comparison& c) const {
    const auto n = static_cast<double>(m_lr.size());
    c.runs = m_lr.size();
    for (const double m : m_lr) c.m_lr_over_m_total += m / n;
    double squares = 0;
    for (const double m : m_lr) squares += (m - c.m_lr_over_m_total) * (m - c.m_lr_over_m_total);
    if (c.runs > 1) c.m_lr_scatter = std::sqrt(squares / (n - 1));
    c.m_slr_over_m_total = m_slr / n;
    const statistics::Ensemble shapes = statistics::ensemble(b_over_a);
    c.b_over_a = mean_of(shapes), c.b_over_a_scatter = deviation_of(shapes);
    for (const auto& [name, count] : classes)
      if (count > c.of_class) c.outcome_class = name, c.of_class = count;
  }
};

bool has_bodies(const db::Connection& connection, std::int64_t job, const CatalogueImpact& impact) {
  const Scene scene = parse_scene(nlohmann::json::parse(db::scene(connection, job)));
  return close(scene.target.radius_m, impact.radius_m) &&
         close(scene.material.rho0_kg_per_m3, impact.rho0_kg_per_m3) && !has_two_materials(scene);
}

}  // namespace

std::optional<double> Comparison::m_lr_difference() const {
  if (runs == 0 || !row->outcome.m_lr_over_m_total) return std::nullopt;
  return m_lr_over_m_total - *row->outcome.m_lr_over_m_total;
}

std::optional<double> Comparison::b_over_a_difference() const {
  if (!b_over_a || !row->outcome.b_over_a) return std::nullopt;
  return *b_over_a - *row->outcome.b_over_a;
}

std::vector<Comparison> compare(const db::Connection& connection, const Catalogue& catalogue) {
  std::vector<Comparison> all;
  for (const CatalogueRow& row : catalogue.rows) {
    std::map<std::pair<std::int64_t, std::string>, Tally> tallies;
    for (const db::ResultRow& found : db::selected_results(connection, at_point_of(row.impact)))
      if (has_bodies(connection, found.job, row.impact))
        tallies[{found.particles_per_target,
                 found.fidelity.empty() ? fmt::format("{} particles", found.particles_per_target)
                                        : found.fidelity}]
            .add(found.result);
    if (tallies.empty()) all.push_back({.row = &row});
    for (const auto& [settings, tally] : tallies) {
      all.push_back({.row = &row, .settings = settings.second});
      tally.finish(all.back());
    }
  }
  return all;
}

namespace {

/// A field of our results; of an impact without any null.
Field<Comparison> ours(Column column, std::function<Value(const Comparison&)> value) {
  return {std::move(column),
          [value](const Comparison& c) { return c.runs > 0 ? value(c) : Value(); }};
}

Field<Comparison> theirs(Column column, std::function<Value(const CatalogueRow&)> value) {
  return {std::move(column), [value](const Comparison& c) { return value(*c.row); }};
}

}  // namespace

text::Table table_of_comparisons(const std::vector<Comparison>& all) {
  using Row = CatalogueRow;
  // Few catalogues have shapes; for the others people need no columns of them.
  const bool has_shapes = std::ranges::any_of(
      all, [](const Comparison& c) { return c.row->outcome.b_over_a.has_value(); });
  const auto shape = [has_shapes](const char* name, const char* header, const char* pattern) {
    Column column = both(name, header, pattern);
    column.for_people = has_shapes;
    return column;
  };
  return text::table_of<Comparison>(
      {theirs(data("run_id"), [](const Row& r) { return r.run_id; }),
       theirs(shown("run"),
              [](const Row& r) {
                return r.run_id.empty() ? fmt::format("line {}", r.line) : r.run_id;
              }),
       theirs(data("line"), [](const Row& r) { return r.line; }),
       theirs(both("v_imp_cm_per_s", "v cm/s", "{:.5g}"),
              [](const Row& r) { return r.impact.v_imp_cm_per_s; }),
       theirs(both("theta_imp_deg", "theta deg", "{:.4g}"),
              [](const Row& r) { return r.impact.theta_imp_deg; }),
       theirs(both("q", "q", "{:.4g}"), [](const Row& r) { return r.impact.q; }),
       ours(both("settings", "settings"), [](const Comparison& c) { return c.settings; }),
       {both("runs", "runs"), [](const Comparison& c) { return c.runs; }},
       theirs(both("class", "class"),
              [](const Row& r) {
                return r.outcome.outcome_class.empty() ? Value() : Value(r.outcome.outcome_class);
              }),
       ours(both("class_ours", "ours"), [](const Comparison& c) { return c.outcome_class; }),
       ours(both("runs_of_class", "of"), [](const Comparison& c) { return c.of_class; }),
       theirs(both("m_lr_over_m_total", "M_lr/M", "{:.3f}"),
              [](const Row& r) { return or_null(r.outcome.m_lr_over_m_total); }),
       ours(both("m_lr_over_m_total_ours", "M_lr/M ours", "{:.3f}"),
            [](const Comparison& c) { return c.m_lr_over_m_total; }),
       ours(both("m_lr_scatter", "+-", "{:.3f}"),
            [](const Comparison& c) { return c.runs > 1 ? Value(c.m_lr_scatter) : Value(); }),
       {both("m_lr_difference", "difference", "{:+.3f}"),
        [](const Comparison& c) { return or_null(c.m_lr_difference()); }},
       theirs(data("m_slr_over_m_total"),
              [](const Row& r) { return or_null(r.outcome.m_slr_over_m_total); }),
       ours(data("m_slr_over_m_total_ours"),
            [](const Comparison& c) { return c.m_slr_over_m_total; }),
       theirs(shape("b_over_a", "b/a", "{:.3f}"),
              [](const Row& r) { return or_null(r.outcome.b_over_a); }),
       {shape("b_over_a_ours", "b/a ours", "{:.3f}"),
        [](const Comparison& c) { return or_null(c.b_over_a); }},
       {shape("b_over_a_scatter", "+-", "{:.3f}"),
        [](const Comparison& c) { return or_null(c.b_over_a_scatter); }},
       {shape("b_over_a_difference", "difference", "{:+.3f}"),
        [](const Comparison& c) { return or_null(c.b_over_a_difference()); }}},
      all);
}

Agreement agreement_of(const std::vector<Comparison>& all) {
  Agreement whole;
  double squares = 0, shape_squares = 0;
  for (const Comparison& c : all) {
    if (c.runs == 0) ++whole.lacking;
    if (const auto difference = c.m_lr_difference())
      ++whole.masses, squares += *difference * *difference;
    if (const auto difference = c.b_over_a_difference())
      ++whole.shapes, shape_squares += *difference * *difference;
    const std::string& theirs = c.row->outcome.outcome_class;
    if (c.runs == 0 || !remnants::outcome_named(theirs)) continue;
    ++whole.classes;
    if (theirs == c.outcome_class) ++whole.same_class;
  }
  if (whole.masses > 0) whole.m_lr_rms = std::sqrt(squares / static_cast<double>(whole.masses));
  if (whole.shapes > 0)
    whole.b_over_a_rms = std::sqrt(shape_squares / static_cast<double>(whole.shapes));
  return whole;
}

}  // namespace eerie::catalogue
