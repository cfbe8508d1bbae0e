#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace eerie::catalogue {

/// An impact of a catalogue as a scene of eerie's needs it.
struct CatalogueImpact {
  double q = 1, v_imp_cm_per_s = 0, theta_imp_deg = 0;
  double radius_m = 0, rho0_kg_per_m3 = 0;
  std::optional<double> phi_d_deg = {};
  std::optional<double> seed = {};
};

/// What the catalogue says became of it.
struct PublishedOutcome {
  std::string outcome_class;  ///< empty: not said
  std::optional<double> m_lr_over_m_total = {}, m_slr_over_m_total = {}, b_over_a = {};
};

struct CatalogueRow {
  std::size_t line = 0;  ///< in the file
  std::string run_id;
  CatalogueImpact impact;
  PublishedOutcome outcome;
  std::string fidelity;  ///< empty: not said
};

struct Catalogue {
  std::vector<CatalogueRow> rows;
  std::vector<std::string> ignored;  ///< headers that name nothing known
};

/// What the file leaves open.
struct CatalogueOptions {
  std::optional<double> density_kg_per_m3;  ///< where there is no such column; default: the scene's
  std::optional<double>
      radius_m;  ///< of all targets in place of the file's: v/v_esc, q, theta stay
};

/// Reads a catalogue of collisions (docs/reference/catalogue.md). Throws InputError naming file,
/// line, column, value, what is allowed and the mend.
Catalogue parse_catalogue(std::string_view text, const std::string& name,
                          const CatalogueOptions& options);

}  // namespace eerie::catalogue
