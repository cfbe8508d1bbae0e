#pragma once

#include <string>
#include <vector>

#include "campaign/catalogue/catalogue.hpp"
#include "campaign/text/table.hpp"
#include "db/store/connection.hpp"

namespace eerie::catalogue {

/// An impact of a catalogue beside the results of one set of settings at its point.
struct Comparison {
  const CatalogueRow* row = nullptr;
  std::string settings = {};       ///< fidelity, or the particles per target where it has no name
  std::size_t runs = 0;            ///< 0: there is no result
  std::string outcome_class = {};  ///< of most runs
  std::size_t of_class = 0;        ///< so many
  double m_lr_over_m_total = 0, m_slr_over_m_total = 0;  ///< means
  double m_lr_scatter = 0;  ///< standard deviation of one run; 0 for a single one
  std::optional<double> b_over_a = {};

  /// Ours less the catalogue's; nothing where either is lacking.
  std::optional<double> m_lr_difference() const;
};

/// Every row of the catalogue, in its order, once for each settings with results of its bodies at
/// its point, or once with no runs. Results of another solver version are left out.
std::vector<Comparison> compare(const db::Connection& connection, const Catalogue& catalogue);

/// A row for each, for programs and for people; null where there is no result.
text::Table table_of_comparisons(const std::vector<Comparison>& all);

/// How well the comparisons agree as a whole.
struct Agreement {
  std::size_t lacking = 0;                  ///< rows without a result
  std::size_t masses = 0;                   ///< rows whose largest masses can be compared ...
  double m_lr_rms = 0;                      ///< ... and the root mean square of the differences
  std::size_t classes = 0, same_class = 0;  ///< rows whose classes can be compared, and are equal
};
Agreement agreement_of(const std::vector<Comparison>& all);

}  // namespace eerie::catalogue
