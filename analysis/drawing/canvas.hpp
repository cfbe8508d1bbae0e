#pragma once

#include <vector>

#include "analysis/drawing/palette.hpp"
#include "analysis/drawing/script.hpp"

namespace eerie::drawing {

/// A position on the page, in PostScript points from the lower left corner.
struct Point {
  double x = 0, y = 0;
};

/// A rectangle on the page, points.
struct Area {
  Point low, high;
  double width() const { return high.x - low.x; }
  double height() const { return high.y - low.y; }
  Point centre() const { return {(low.x + high.x) / 2, (low.y + high.y) / 2}; }
};

enum class Align { left, centre };

/// The typography of words.
struct Style {
  double size = 6;  ///< points
  Colour colour;
  Align align = Align::centre;
  bool bold = false;
  bool upwards = false;  ///< turned by 90 degrees
};

/// Collects the gnuplot commands for shapes and words at fixed positions on the page. Shapes lie
/// behind axes and curves; words lie in front of them.
class Canvas {
 public:
  Canvas(double width_pt, double height_pt) : width_(width_pt), height_(height_pt) {}

  void fill(const Area& area, Colour colour);
  /// Fills an area in front of the curves and behind the words.
  void patch(const Area& area, Colour colour);
  void outline(const Area& area, Colour colour, double line_width);
  void line(Point from, Point to, Colour colour, double line_width);
  void polygon(const std::vector<Point>& corners, Colour colour);
  /// Draws lines that rise to the right, `distance` points apart, cut at the borders of the area.
  void hatch(const Area& area, Colour colour, double distance);
  /// Draws horizontal lines, `distance` points apart.
  void rule(const Area& area, Colour colour, double distance);
  void cross(const Area& area, Colour colour);
  /// Writes words, centred on `at` across their direction.
  void text(Point at, const Quoted& words, const Style& style);

  const Script& commands() const { return commands_; }

 private:
  Script at(Point p) const;
  void rectangle(const Area& area, Colour colour, Literal layer);
  double width_, height_;
  int objects_ = 0;
  Script commands_;
};

/// The approximate width of words in DejaVu Sans, points.
double text_width(const Quoted& words, double size);

}  // namespace eerie::drawing
