#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace eerie::catalogue {

/// An impact of a catalogue, with the numbers that a scene of eerie needs.
struct CatalogueImpact {
  double q = 1, v_imp_cm_per_s = 0, theta_imp_deg = 0;
  double radius_m = 0, rho0_kg_per_m3 = 0;
  std::optional<double> phi_d_deg = {};
  std::optional<double> seed = {};
};

/// The outcome of an impact in the catalogue.
struct PublishedOutcome {
  std::string outcome_class;  ///< empty: not said
  std::optional<double> m_lr_over_m_total = {}, m_slr_over_m_total = {}, b_over_a = {};
};

struct CatalogueRow {
  std::size_t line = 0;  ///< its number in the file
  std::string run_id;
  CatalogueImpact impact;
  PublishedOutcome outcome;
  std::string fidelity;  ///< empty: not said
};

struct Catalogue {
  std::vector<CatalogueRow> rows;
  std::vector<std::string> ignored;  ///< headers that are not recognised
};

/// Values for what the file does not say.
struct CatalogueOptions {
  /// Used where there is no such column; default: that of a scene.
  std::optional<double> density_kg_per_m3;
  /// Replaces the radius of all targets; v/v_esc, q and theta stay.
  std::optional<double> radius_m;
};

/// Reads a catalogue of collisions (docs/reference/catalogue.md). Throws InputError, which names file, line,
/// column, value, the allowed values and the mend.
Catalogue parse_catalogue(std::string_view text, const std::string& name,
                          const CatalogueOptions& options);

}  // namespace eerie::catalogue
