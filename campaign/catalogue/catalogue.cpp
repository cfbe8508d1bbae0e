#include "campaign/catalogue/catalogue.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <cstdlib>
#include <map>

#include "campaign/catalogue/quantities.hpp"
#include "campaign/text/csv_table.hpp"
#include "solver/base/bodies/sphere.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/error.hpp"

namespace eerie::catalogue {
namespace {

using Columns = std::map<CatalogueQuantity, std::pair<std::size_t, CatalogueColumn>>;

constexpr double default_density = 2700;  // of the scene, kg/m^3
constexpr double most_disagreement = 0.01;

/// Derived numbers carry no more digits than this: 49.99999999999999 was 50.
double rounded(double value) { return std::strtod(fmt::format("{:.12g}", value).c_str(), nullptr); }

/// A row while it is read: fields by quantity, with what is said where one is wrong.
class Reader {
 public:
  Reader(const text::CsvTable& table, const Columns& columns, const text::CsvTable::Row& row,
         const std::string& name)
      : table_(table), columns_(columns), row_(row), name_(name) {}

  std::string text(CatalogueQuantity quantity) const {
    const auto at = columns_.find(quantity);
    return at == columns_.end() ? "" : row_.fields[at->second.first];
  }

  /// In SI with the decimal point moved; nothing where the column or the value is missing.
  std::optional<double> number(CatalogueQuantity quantity, double least, double most,
                               int decimals = 0) const {
    const std::string field = text(quantity);
    if (field.empty()) return std::nullopt;
    const Unit& unit = columns_.at(quantity).second.unit;
    const auto value = value_of(field, unit, decimals);
    if (!value) refuse(quantity, "must be a number; mend it, or leave the field empty");
    if (!(*value >= least)) refuse(quantity, fmt::format("must be at least {:g}", least));
    if (!(*value <= most))
      refuse(quantity, fmt::format("must be at least {:g} and at most {:g}", least, most));
    return unit.factor == 1 ? *value : rounded(*value);
  }
  std::optional<double> positive(CatalogueQuantity quantity) const {
    const auto value = number(quantity, 0, 1e300);
    if (value && *value == 0) refuse(quantity, "must be greater than 0");
    return value;
  }

  [[noreturn]] void refuse(CatalogueQuantity quantity, const std::string& why) const {
    throw InputError(fmt::format("{}, {} = {}: {}", where(),
                                 table_.header[columns_.at(quantity).first], text(quantity), why));
  }
  [[noreturn]] void lack(const std::string& what) const {
    throw InputError(fmt::format("{}: {}", where(), what));
  }
  bool has(CatalogueQuantity quantity) const { return columns_.contains(quantity); }
  std::string where() const { return fmt::format("{}, line {}", name_, row_.line); }

 private:
  const text::CsvTable& table_;
  const Columns& columns_;
  const text::CsvTable::Row& row_;
  const std::string& name_;
};

Columns columns_of(const text::CsvTable& table, const std::string& name,
                   std::vector<std::string>& ignored) {
  Columns columns;
  for (std::size_t k = 0; k < table.header.size(); ++k) {
    const auto column = column_of(table.header[k], name);
    if (!column) {
      ignored.push_back(table.header[k]);
      continue;
    }
    const auto [known, is_new] = columns.emplace(column->quantity, std::pair(k, *column));
    if (!is_new)
      throw InputError(fmt::format("{}: columns {} and {} both say {}; remove one of them", name,
                                   table.header[known->second.first], table.header[k],
                                   column_name(column->quantity)));
  }
  return columns;
}

/// At least one of each group must be there; said once, before any row.
void require_columns(const Columns& columns, const std::string& name) {
  using enum CatalogueQuantity;
  const std::vector<std::vector<CatalogueQuantity>> groups = {
      {v_imp, v_imp_over_v_esc},
      {theta_imp, b},
      {m_projectile, q},
      {m_target, m_total, r_target, v_imp_over_v_esc}};
  for (const std::vector<CatalogueQuantity>& group : groups) {
    std::vector<std::string> names;
    bool there = false;
    for (const CatalogueQuantity one : group) {
      names.push_back(column_name(one));
      there = there || columns.contains(one);
    }
    if (!there)
      throw InputError(
          fmt::format("{}: no column says {}; add one of them", name, fmt::join(names, " or ")));
  }
}

struct Bodies {
  double q = 1, radius_m = 0, rho0 = 0;
  double total_kg = 0;        ///< as the catalogue has it
  double escape_m_per_s = 0;  ///< of the catalogue's bodies; 0 where their size is not known
};

double mass_ratio(const Reader& row, std::optional<double>& target_kg) {
  using enum CatalogueQuantity;
  const auto ratio = row.positive(q), m_p = row.positive(m_projectile),
             m_tot = row.positive(m_total);
  if (ratio && *ratio > 1) row.refuse(q, "must be at most 1; call the larger body the target");
  if (!target_kg && m_tot && m_p) target_kg = *m_tot - *m_p;
  if (!target_kg && m_tot && ratio) target_kg = *m_tot / (1 + *ratio);
  if (!target_kg && m_p && ratio) target_kg = *m_p / *ratio;
  if (ratio && m_p && target_kg && std::abs(*m_p / *target_kg / *ratio - 1) > most_disagreement)
    row.refuse(
        q, fmt::format("the masses have the ratio {:.4g}; mend one of them", *m_p / *target_kg));
  if (ratio) return *ratio;
  if (!m_p) row.lack("neither q nor m_projectile has a value; give one");
  if (!target_kg) row.lack("the mass of the target is missing; give m_target or q");
  if (*m_p > *target_kg)
    row.refuse(m_projectile, fmt::format("must be at most m_target = {:g} kg; call the larger body "
                                         "the target",
                                         *target_kg));
  return rounded(*m_p / *target_kg);
}

Bodies bodies_of(const Reader& row, const CatalogueOptions& options) {
  using enum CatalogueQuantity;
  Bodies bodies;
  auto m_t = row.positive(m_target);
  const auto radius = row.positive(r_target), density = row.positive(rho);
  if (!m_t && radius && density) m_t = sphere_volume(*radius) * *density;
  bodies.q = mass_ratio(row, m_t);
  if (density)
    bodies.rho0 = *density;
  else if (!options.radius_m && radius && m_t)
    bodies.rho0 = rounded(*m_t / sphere_volume(*radius));
  else
    bodies.rho0 = options.density_kg_per_m3.value_or(default_density);
  if (radius)
    bodies.radius_m = *radius;
  else if (m_t)
    bodies.radius_m = rounded(std::cbrt(*m_t / bodies.rho0 / sphere_volume(1)));
  else if (!options.radius_m)
    row.lack("the size of the target is missing; give m_target or r_target, or --radius");
  if (radius && density && m_t) {
    const double mass = sphere_volume(*radius) * *density;
    if (std::abs(mass / *m_t - 1) > most_disagreement)
      row.refuse(r_target, fmt::format("with the density it makes {:.4g} kg and m_target is {:.4g} "
                                       "kg; mend one of the three",
                                       mass, *m_t));
  }
  const double target = m_t.value_or(sphere_volume(bodies.radius_m) * bodies.rho0);
  bodies.total_kg = target * (1 + bodies.q);
  if (bodies.radius_m > 0)
    bodies.escape_m_per_s =
        mutual_escape_speed({bodies.radius_m, target / sphere_volume(bodies.radius_m)}, bodies.q);
  return bodies;
}

double angle_of(const Reader& row) {
  using enum CatalogueQuantity;
  if (const auto angle = row.number(theta_imp, 0, 89)) return *angle;
  const auto sine = row.number(b, 0, 0.9998);
  if (!sine) row.lack("the impact angle is missing; give theta_imp_deg, or b = sin(theta)");
  return rounded(degrees(std::asin(*sine)));
}

/// cm/s. With --radius the ratio to the escape speed is what stays.
double speed_of(const Reader& row, const Bodies& bodies, const CatalogueOptions& options) {
  using enum CatalogueQuantity;
  constexpr double fastest_cm_per_s = 1e4;
  const auto ratio = row.positive(v_imp_over_v_esc);
  const auto v = row.number(v_imp, 0, 1e300, 2);
  if (v && *v == 0) row.refuse(v_imp, "must be greater than 0");
  if (!v && !ratio) row.lack("the impact speed is missing; give v_imp or v_imp_over_v_esc");
  const double escape = 100 * bodies.escape_m_per_s;
  if (options.radius_m) {
    if (!ratio && escape == 0)
      row.lack(
          "v_imp_over_v_esc is missing and cannot be derived without the target's size; give "
          "it, or m_target");
    return rounded(ratio.value_or(v.value_or(0) / escape) * 100 *
                   mutual_escape_speed({*options.radius_m, bodies.rho0}, bodies.q));
  }
  const double speed = v ? *v : rounded(*ratio * escape);
  if (speed > fastest_cm_per_s)
    row.refuse(v ? v_imp : v_imp_over_v_esc,
               fmt::format("is {:.4g} m/s, and impacts of eerie's bodies have at most {:g} m/s; "
                           "--radius 50 runs it with the same v/v_esc, mass ratio and angle on a "
                           "target of 50 m",
                           speed / 100, fastest_cm_per_s / 100));
  return speed;
}

PublishedOutcome outcome_of(const Reader& row, const Bodies& bodies) {
  using enum CatalogueQuantity;
  constexpr double most = 1 + most_disagreement;
  PublishedOutcome outcome;
  outcome.outcome_class = row.text(CatalogueQuantity::outcome_class);
  outcome.b_over_a = row.number(b_over_a, 0, 1);
  outcome.m_lr_over_m_total = row.number(m_lr_over_m_total, 0, most);
  outcome.m_slr_over_m_total = row.number(m_slr_over_m_total, 0, most);
  const auto part = [&](CatalogueQuantity mass, std::optional<double>& fraction) {
    const auto kg = row.number(mass, 0, 1e300);
    if (!kg || fraction) return;
    if (!(bodies.total_kg > 0)) row.refuse(mass, "needs the mass of the target; give m_target");
    fraction = *kg / bodies.total_kg;
    if (*fraction > most)
      row.refuse(
          mass, fmt::format("must be at most the mass of both bodies, {:.4g} kg", bodies.total_kg));
  };
  part(m_lr, outcome.m_lr_over_m_total);
  part(m_slr, outcome.m_slr_over_m_total);
  // Asphaug (2009): xi = (m_lr - m_target) / m_projectile.
  if (const auto xi = row.number(accretion_efficiency, -1 / bodies.q * most, most);
      xi && !outcome.m_lr_over_m_total)
    outcome.m_lr_over_m_total = (1 + *xi * bodies.q) / (1 + bodies.q);
  return outcome;
}

CatalogueRow row_of(const Reader& row, std::size_t line, const CatalogueOptions& options) {
  using enum CatalogueQuantity;
  CatalogueRow out;
  out.line = line;
  out.run_id = row.text(run_id);
  out.fidelity = row.text(fidelity);
  const Bodies bodies = bodies_of(row, options);
  CatalogueImpact& impact = out.impact;
  impact.q = bodies.q;
  impact.rho0_kg_per_m3 = bodies.rho0;
  impact.radius_m = options.radius_m.value_or(bodies.radius_m);
  impact.theta_imp_deg = angle_of(row);
  impact.v_imp_cm_per_s = speed_of(row, bodies, options);
  for (const double value :
       {impact.q, impact.rho0_kg_per_m3, impact.radius_m, impact.v_imp_cm_per_s})
    if (!(value > 0 && std::isfinite(value)))
      row.lack("masses, sizes and speeds are too large or too small to make an impact; mend them");
  impact.phi_d_deg = row.number(phi_d, 0, 80);
  impact.seed = row.number(seed, 0, 4294967295.0);
  out.outcome = outcome_of(row, bodies);
  return out;
}

}  // namespace

Catalogue parse_catalogue(std::string_view text, const std::string& name,
                          const CatalogueOptions& options) {
  const text::CsvTable table = text::parse_csv(text, name);
  Catalogue catalogue;
  const Columns columns = columns_of(table, name, catalogue.ignored);
  require_columns(columns, name);
  if (table.rows.empty())
    throw InputError(name + ": has a header and no impact; add a line for each");
  for (const text::CsvTable::Row& row : table.rows)
    catalogue.rows.push_back(row_of(Reader(table, columns, row, name), row.line, options));
  return catalogue;
}

}  // namespace eerie::catalogue
