#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/canvas.hpp"
#include "analysis/phase_diagram.hpp"

namespace eerie {

/// Explains the marks that occur in a figure, in rows under it.
class PhaseLegend {
 public:
  PhaseLegend(const PhaseFigure& figure, double width_pt);
  double height_pt() const;
  void draw(Canvas& canvas, Point upper_left) const;

 private:
  enum class Mark {
    letter,
    curve,
    blue,
    corner,
    missing,
    pending,
    failed,
    unsettled,
    stale,
    doubt
  };
  struct Entry {
    Mark mark;
    std::string letter, words;
    std::optional<Colour> fill = {};  ///< behind a letter
    double x = 0;
    int row = 0;
  };
  void add_curve(const PhaseFigure& figure);
  void add_classes(const PhaseFigure& figure);
  void add_states(const PhaseFigure& figure);
  static void draw_mark(Canvas& canvas, const Entry& entry, const Area& box);
  std::vector<Entry> entries_;
};

}  // namespace eerie
