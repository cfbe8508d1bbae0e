#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/drawing/script.hpp"

namespace eerie::proof {

/// One line or set of points of a figure.
struct Curve {
  std::string title;
  std::vector<double> x, y;
  drawing::Literal style = "lines lw 2";  ///< gnuplot's "with ..."
  int colour = 0;                         ///< from 1; 0: the place in the figure
};

/// A figure of curves, drawn by gnuplot as SVG.
struct Figure {
  std::string name, caption, x_label, y_label;
  std::vector<Curve> curves;
  drawing::Literal extra = "";  ///< further gnuplot settings, e.g. "set logscale x"
};

/// What a proof measured: it is checked as a test and kept for the report. Where EERIE_REPORT
/// names a folder (`make validate`), the record is installed there as JSON and its figures as SVG;
/// without it only the checks remain.
class Record {
 public:
  /// `page`: "validation" or "stability"; `order`: place on the page; `text`: what is shown,
  /// against what, in Markdown.
  Record(std::string page, int order, std::string title, std::string text);
  ~Record();
  Record(const Record&) = delete;
  Record& operator=(const Record&) = delete;

  /// Fails the test unless lo <= value <= hi. `what` ends in its unit where it has one: "period,
  /// h". `reason`: where the bounds come from; of many checks with one reason the page shows one.
  void within(const std::string& what, double value, double lo, double hi,
              const std::string& reason);
  /// A result outside of what one would wish, that is known and said: no test fails.
  void noted(const std::string& what, double value, const std::string& wish,
             const std::string& why);
  void figure(const Figure& figure);
  /// A table of its own: head and rows of text.
  void table(const std::vector<std::string>& head,
             const std::vector<std::vector<std::string>>& rows);
  void say(const std::string& markdown);

 private:
  nlohmann::json json_;
};

}  // namespace eerie::proof
