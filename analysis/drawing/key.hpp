#pragma once

#include <optional>
#include <vector>

#include "analysis/drawing/canvas.hpp"

namespace eerie::drawing {

/// What a line, a mark or a fill of a figure means. The samples that are not empty are drawn.
struct KeyEntry {
  Quoted words;
  Script line = {};   ///< "lw 1 dt 2 lc rgb '#000000'"
  Script point = {};  ///< "pt 7 ps 0.5 lc rgb '#000000'"
  std::optional<Colour> fill = {};
};

/// A legend in rows, each as wide as the page allows. Widths are those of the letters, so nothing
/// runs together or over the border. An entry that is wider than a row has a row of its own.
class Key {
 public:
  static constexpr double size = 6.5, row_height = 9.5;

  Key(std::vector<KeyEntry> entries, double width_pt);
  double height_pt() const { return rows_ * row_height; }
  void draw(Canvas& canvas, Point upper_left) const;

 private:
  struct Place {
    double x = 0;
    int row = 0;
  };
  std::vector<KeyEntry> entries_;
  std::vector<Place> places_;
  int rows_ = 0;
};

}  // namespace eerie::drawing
