#include "analysis/drawing/canvas.hpp"

#include <algorithm>
#include <cmath>

namespace eerie::drawing {

Script Canvas::at(Point p) const {
  return script("screen {:.5f},{:.5f}", p.x / width_, p.y / height_);
}

void Canvas::rectangle(const Area& area, Colour colour, Literal layer) {
  commands_ += script("set object {} rectangle from {} to {} {} fc rgb '{}' fs solid noborder\n",
                      ++objects_, at(area.low), at(area.high), layer, colour);
}

void Canvas::fill(const Area& area, Colour colour) { rectangle(area, colour, "behind"); }
void Canvas::patch(const Area& area, Colour colour) { rectangle(area, colour, "front"); }

void Canvas::outline(const Area& area, Colour colour, double line_width) {
  const Point ul{area.low.x, area.high.y}, lr{area.high.x, area.low.y};
  line(area.low, lr, colour, line_width), line(lr, area.high, colour, line_width);
  line(area.high, ul, colour, line_width), line(ul, area.low, colour, line_width);
}

void Canvas::line(Point from, Point to, Colour colour, double line_width) {
  commands_ += script("set arrow from {} to {} nohead back lw {} lc rgb '{}'\n", at(from), at(to),
                      line_width, colour);
}

void Canvas::styled_line(Point from, Point to, const Script& style) {
  commands_ += script("set arrow from {} to {} nohead back {}\n", at(from), at(to), style);
}

void Canvas::mark(Point p, const Script& style) {
  commands_ += script("set label '' at {} point {}\n", at(p), style);
}

void Canvas::polygon(const std::vector<Point>& corners, Colour colour) {
  Script path = "from " + at(corners.front());
  for (std::size_t i = 1; i < corners.size(); ++i) path += " to " + at(corners[i]);
  commands_ += script("set object {} polygon {} to {} behind fc rgb '{}' fs solid noborder\n",
                      ++objects_, path, at(corners.front()), colour);
}

void Canvas::hatch(const Area& area, Colour colour, double distance) {
  const double step = distance * std::sqrt(2.0), w = area.width(), h = area.height();
  for (double start = step / 2 - h; start < w; start += step) {
    // From the lower border (or the left one) up to the right border (or the upper one).
    const double x0 = std::max(start, 0.0), x1 = std::min(start + h, w);
    line({area.low.x + x0, area.low.y + x0 - start}, {area.low.x + x1, area.low.y + x1 - start},
         colour, 0.4);
  }
}

void Canvas::rule(const Area& area, Colour colour, double distance) {
  for (double y = area.low.y + distance / 2; y < area.high.y; y += distance)
    line({area.low.x, y}, {area.high.x, y}, colour, 0.4);
}

void Canvas::cross(const Area& area, Colour colour) {
  line(area.low, area.high, colour, 0.6);
  line({area.low.x, area.high.y}, {area.high.x, area.low.y}, colour, 0.6);
}

void Canvas::text(Point p, const Quoted& words, const Style& style) {
  const Literal side = style.align == Align::left ? Literal("left") : Literal("center");
  const Literal turn = style.upwards ? Literal(" rotate by 90") : Literal("");
  const Literal weight = style.bold ? Literal(":Bold") : Literal("");
  commands_ += script("set label {} at {} {}{} front font 'DejaVu Sans{},{}' tc rgb '{}'\n", words,
                      at(p), side, turn, weight, style.size, style.colour);
}

double text_width(const Quoted& words, double size, bool bold) { return size * words.width(bold); }

double size_that_fits(const Quoted& words, double room, double most) {
  return std::min(most, room / std::max(words.width(), 1e-9));
}

}  // namespace eerie::drawing
