#pragma once

#include <optional>
#include <string>
#include <vector>

namespace eerie::disk {

/// A number of Sugiura et al. (2019) beside what its own formulas give.
struct PublishedNumber {
  std::string quantity, unit, source;  ///< source: section, equation or figure
  double paper = 0;
  int digits = 1;                     ///< significant ones that the paper gives
  std::optional<double> by_formulas;  ///< from the paper's formulas and constants
  std::optional<double> by_nebula;    ///< from Hayashi's nebula and Weidenschilling's drag

  /// What there is to compare with: by_formulas, else by_nebula.
  double computed() const { return by_formulas ? *by_formulas : *by_nebula; }
};

/// Whether `value` rounds to the number as the paper prints it: half a unit of its last digit.
bool agrees(const PublishedNumber& number, double value);

/// Every number on the disk that the paper quotes and that follows from something. All constants
/// are the paper's or Hayashi's; none is adjusted.
std::vector<PublishedNumber> published_numbers();

/// One line per number, with a header.
std::string published_numbers_csv(const std::vector<PublishedNumber>& numbers);

}  // namespace eerie::disk
