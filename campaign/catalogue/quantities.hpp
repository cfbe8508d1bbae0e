#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace eerie::catalogue {

/// The quantities that a column of a catalogue of collisions may have.
enum class CatalogueQuantity {
  run_id,
  v_imp,
  v_imp_over_v_esc,
  theta_imp,
  b,
  m_target,
  m_projectile,
  m_total,
  q,
  r_target,
  rho,
  phi_d,
  m_lr,
  m_slr,
  m_lr_over_m_total,
  m_slr_over_m_total,
  accretion_efficiency,
  outcome_class,
  b_over_a,
  seed,
  fidelity
};

/// A unit of a quantity: value * 10^decimals * factor is in SI (degrees for angles).
struct Unit {
  std::string_view name;  ///< in lower case, with "per" for a slash
  int decimals = 0;
  double factor = 1;
};

/// A column whose header is recognised.
struct CatalogueColumn {
  CatalogueQuantity quantity = CatalogueQuantity::run_id;
  Unit unit;
};

/// The name of the column in catalogues that eerie writes, with its unit: "m_target_kg".
std::string column_name(CatalogueQuantity quantity);

/// Reads a header such as "m_target_kg", "M_targ (kg)", "V_i/V_esc", "theta [deg]". Nothing where
/// it names no known quantity. Throws InputError, which begins with `where`, for a quantity without
/// its unit.
std::optional<CatalogueColumn> column_of(const std::string& header, const std::string& where);

/// The value of a field in SI (degrees for angles); nothing where it is no number. Powers of ten
/// move the decimal point, so 0.18 m/s is exactly 18 cm/s with `decimals` of 2.
std::optional<double> value_of(const std::string& field, const Unit& unit, int decimals = 0);

/// A number with its decimal point moved and all its digits: (17.3, -2) is "0.173".
std::string moved(double value, int decimals);

}  // namespace eerie::catalogue
