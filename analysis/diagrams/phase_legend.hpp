#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "analysis/diagrams/phase_diagram.hpp"
#include "analysis/drawing/canvas.hpp"

namespace eerie::diagrams {

/// Explains the marks of a figure, in rows below it.
class PhaseLegend {
 public:
  PhaseLegend(const PhaseFigure& figure, double width_pt);
  double height_pt() const;
  void draw(drawing::Canvas& canvas, drawing::Point upper_left) const;

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
    drawing::Quoted letter, words;
    std::optional<drawing::Colour> fill = {};  ///< the fill behind a letter
    double x = 0;
    int row = 0;
  };
  void add(Mark mark, std::string_view letter, std::string_view words,
           std::optional<drawing::Colour> fill = {});
  void add_curve(const PhaseFigure& figure);
  void add_classes(const PhaseFigure& figure);
  void add_states(const PhaseFigure& figure);
  static void draw_mark(drawing::Canvas& canvas, const Entry& entry, const drawing::Area& box);
  std::vector<Entry> entries_;
};

}  // namespace eerie::diagrams
