#pragma once

#include <optional>
#include <string>
#include <vector>

namespace eerie::disk {

/// A number of Sugiura et al. (2019), and the value that the formulas of the paper give.
struct PublishedNumber {
  std::string quantity, unit, source;  ///< `source` is a section, equation or figure
  double paper = 0;
  int digits = 1;                     ///< significant digits in the paper
  std::optional<double> by_formulas;  ///< by the formulas and constants of the paper
  std::optional<double> by_nebula;    ///< by Hayashi's nebula and Weidenschilling's drag

  /// The value to compare with: by_formulas, or by_nebula where that is missing.
  double computed() const { return by_formulas ? *by_formulas : *by_nebula; }
};

/// Whether `value` rounds to the printed number, that is, within half a unit of its last digit.
bool agrees(const PublishedNumber& number, double value);

/// All numbers about the disk that the paper quotes and that follow from a formula. All constants
/// are the paper's or Hayashi's; none is adjusted.
std::vector<PublishedNumber> published_numbers();

/// A CSV table with one line per number, and a header.
std::string published_numbers_csv(const std::vector<PublishedNumber>& numbers);

}  // namespace eerie::disk
