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
  /// Draws a line in a style of gnuplot: "lw 1 dt 2 lc rgb '#000000'".
  void styled_line(Point from, Point to, const Script& style);
  /// Draws a mark in a style of gnuplot: "pt 7 ps 0.5 lc rgb '#000000'".
  void mark(Point at, const Script& style);
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

/// The width of words in DejaVu Sans, points.
double text_width(const Quoted& words, double size, bool bold = false);

/// The largest type size up to `most` at which the words are at most `room` points wide.
double size_that_fits(const Quoted& words, double room, double most);

}  // namespace eerie::drawing
