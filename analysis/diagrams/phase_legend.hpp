#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "analysis/diagrams/phase_diagram.hpp"
#include "analysis/drawing/canvas.hpp"

namespace eerie::diagrams {

/// Explains the marks of a figure, in rows. `letters`: cells show the letters of classes.
/// `left_out` names diagrams that are not drawn since nothing of them has run.
class PhaseLegend {
 public:
  PhaseLegend(const PhaseFigure& figure, double width_pt, bool letters = true,
              const std::vector<drawing::Quoted>& left_out = {});
  double height_pt() const;
  void draw(drawing::Canvas& canvas, drawing::Point upper_left) const;

 private:
  enum class Mark {
    letter,
    curve,
    border,
    border_ends,
    blue,
    corner,
    missing,
    pending,
    failed,
    unsettled,
    stale,
    doubt,
    none
  };
  struct Entry {
    Mark mark;
    drawing::Quoted letter, words;
    std::optional<drawing::Colour> fill = {};  ///< the fill behind a letter
    double x = 0;
    int row = 0;
  };
  void add(Mark mark, std::string_view letter, std::string_view words,
           std::optional<drawing::Colour> fill = {});
  void add_curve(const PhaseFigure& figure);
  void add_borders(const PhaseFigure& figure);
  void add_classes(const PhaseFigure& figure, bool letters);
  void add_states(const PhaseFigure& figure, bool letters);
  static double symbol_of(const Entry& entry);
  static void draw_mark(drawing::Canvas& canvas, const Entry& entry, const drawing::Area& box);
  std::vector<Entry> entries_;
};

}  // namespace eerie::diagrams
