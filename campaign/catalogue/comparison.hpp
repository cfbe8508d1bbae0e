#pragma once

#include <string>
#include <vector>

#include "campaign/catalogue/catalogue.hpp"
#include "campaign/text/table.hpp"
#include "db/store/connection.hpp"

namespace eerie::catalogue {

/// An impact of a catalogue and the results of one set of settings at its point.
struct Comparison {
  const CatalogueRow* row = nullptr;
  /// The fidelity, or the particles per target where the settings have no name.
  std::string settings = {};
  std::size_t runs = 0;                                  ///< 0: there is no result
  std::string outcome_class = {};                        ///< the class of most runs
  std::size_t of_class = 0;                              ///< the number of runs with that class
  double m_lr_over_m_total = 0, m_slr_over_m_total = 0;  ///< means
  double m_lr_scatter = 0;              ///< standard deviation of one run; 0 for a single one
  std::optional<double> b_over_a = {};  ///< mean of the largest remnant
  std::optional<double> b_over_a_scatter = {};  ///< of one run; nothing for fewer than two

  // The values of eerie minus those of the catalogue; nothing where one is missing.
  std::optional<double> m_lr_difference() const;
  std::optional<double> b_over_a_difference() const;
};

/// Compares every row of the catalogue, in its order, with each settings that have results of its
/// bodies at its point, or once without runs. Results of another solver version are left out.
std::vector<Comparison> compare(const db::Connection& connection, const Catalogue& catalogue);

/// A table with one row per comparison, for programs and for people. Values are null where there is
/// no result.
text::Table table_of_comparisons(const std::vector<Comparison>& all);

/// The agreement of all comparisons.
struct Agreement {
  std::size_t lacking = 0;  ///< rows without a result
  std::size_t masses = 0;   ///< rows whose largest masses can be compared
  double m_lr_rms = 0;      ///< root mean square of the differences of these masses
  std::size_t shapes = 0;   ///< rows whose b/a can be compared
  double b_over_a_rms = 0;  ///< root mean square of the differences of these
  std::size_t classes = 0,
              same_class = 0;  ///< rows whose classes can be compared; those with equal classes
};
Agreement agreement_of(const std::vector<Comparison>& all);

}  // namespace eerie::catalogue
