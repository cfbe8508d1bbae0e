#include "analysis/drawing/canvas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace eerie::drawing {

std::string Canvas::at(Point p) const {
  return fmt::format("screen {:.5f},{:.5f}", p.x / width_, p.y / height_);
}

void Canvas::rectangle(const Area& area, Colour colour, const char* layer) {
  commands_ +=
      fmt::format("set object {} rectangle from {} to {} {} fc rgb '{}' fs solid noborder\n",
                  ++objects_, at(area.low), at(area.high), layer, hex(colour));
}

void Canvas::fill(const Area& area, Colour colour) { rectangle(area, colour, "behind"); }
void Canvas::patch(const Area& area, Colour colour) { rectangle(area, colour, "front"); }

void Canvas::outline(const Area& area, Colour colour, double line_width) {
  const Point ul{area.low.x, area.high.y}, lr{area.high.x, area.low.y};
  line(area.low, lr, colour, line_width), line(lr, area.high, colour, line_width);
  line(area.high, ul, colour, line_width), line(ul, area.low, colour, line_width);
}

void Canvas::line(Point from, Point to, Colour colour, double line_width) {
  commands_ += fmt::format("set arrow from {} to {} nohead back lw {} lc rgb '{}'\n", at(from),
                           at(to), line_width, hex(colour));
}

void Canvas::polygon(const std::vector<Point>& corners, Colour colour) {
  std::string path = "from " + at(corners.front());
  for (std::size_t i = 1; i < corners.size(); ++i) path += " to " + at(corners[i]);
  commands_ += fmt::format("set object {} polygon {} to {} behind fc rgb '{}' fs solid noborder\n",
                           ++objects_, path, at(corners.front()), hex(colour));
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

void Canvas::text(Point p, std::string_view words, const Style& style) {
  commands_ += fmt::format(
      "set label \"{}\" at {} {}{} front font 'DejaVu Sans{},{}' tc rgb '{}'\n", words, at(p),
      style.align == Align::left ? "left" : "center", style.upwards ? " rotate by 90" : "",
      style.bold ? ":Bold" : "", style.size, hex(style.colour));
}

double text_width(std::string_view words, double size) {
  // Continuation bytes of UTF-8 take no room.
  const auto letters = std::ranges::count_if(
      words, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; });
  return 0.56 * size * static_cast<double>(letters);
}

}  // namespace eerie::drawing
