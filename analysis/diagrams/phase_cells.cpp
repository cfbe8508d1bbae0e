#include "analysis/diagrams/phase_cells.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/remnants/outcome.hpp"
#include "analysis/remnants/remnants.hpp"

namespace eerie::diagrams {

namespace {

constexpr double value_size = 6;

/// Of lines over a fill.
drawing::Colour over(drawing::Colour fill) {
  const double l = drawing::lightness(fill);
  return l < 45   ? drawing::Colour{0xb8, 0xb6, 0xb2}
         : l < 66 ? drawing::Colour{0x30, 0x2b, 0x26}
                  : drawing::Colour{0x70, 0x66, 0x5c};
}

}  // namespace

namespace map_mark {

void missing(drawing::Canvas& canvas, const drawing::Area& area) {
  canvas.fill(area, {255, 255, 255});
  const drawing::Point c = area.centre();
  canvas.fill({{c.x - 0.8, c.y - 0.8}, {c.x + 0.8, c.y + 0.8}}, grey);
}

void pending(drawing::Canvas& canvas, const drawing::Area& area) {
  canvas.fill(area, pale);
  canvas.hatch(area, grey, 2.4);
}

void failed(drawing::Canvas& canvas, const drawing::Area& area) {
  canvas.fill(area, {255, 255, 255});
  canvas.cross(area, failure);
}

void unsettled(drawing::Canvas& canvas, const drawing::Area& area, drawing::Colour fill,
               double distance) {
  canvas.hatch(area, over(fill), distance);
}

void stale(drawing::Canvas& canvas, const drawing::Area& area, drawing::Colour fill,
           double distance) {
  canvas.rule(area, over(fill), distance);
}

void smaller_eer(drawing::Canvas& canvas, const drawing::Area& area) {
  const double side = std::min({6.0, area.width() / 2, area.height() / 2});
  const drawing::Point corner = area.high;
  const drawing::Point left{corner.x - side, corner.y}, down{corner.x, corner.y - side};
  canvas.polygon({corner, left, down}, eer);
  canvas.line(left, down, {255, 255, 255}, 0.6);  // it may lie on blue
}

void in_doubt(drawing::Canvas& canvas, const drawing::Area& area) {
  canvas.outline({{area.low.x + 1, area.low.y + 1}, {area.high.x - 1, area.high.y - 1}}, failure,
                 1.2);
}

std::string basis(const PhaseCell& cell) {
  const char letter = cell.fidelity == "sketch" ? 'k' : cell.fidelity == "survey" ? 'v' : 'p';
  return fmt::format("{}{}", letter, cell.seeds);
}

}  // namespace map_mark

namespace {

bool fits(const std::string& words, double size, const drawing::Area& area) {
  return drawing::text_width(drawing::in_quotes(words), size) + 1 <= area.width();
}

/// "0.24", ".24" where that has no room, or nothing.
std::string value_text(MapQuantity quantity, double value, const drawing::Area& area) {
  std::string words = value_words(quantity, value);
  if (!fits(words, value_size, area))
    words = words.starts_with("0.") ? words.substr(1) : words == "1.00" ? "1" : words;
  return fits(words, value_size, area) ? words : "";
}

/// Class, "?" where remnants will meet again, and what the result rests on where cells differ.
std::string letter_text(const PhaseCell& cell, const drawing::Area& area) {
  const auto row =
      std::ranges::find(remnants::outcome_names, cell.outcome, &remnants::OutcomeName::name);
  std::string words(row->short_name);
  if (cell.state == CellState::unsettled) words += "?";
  if (!cell.fidelity.empty()) words += " " + map_mark::basis(cell);
  return fits(words, map_mark::letter_size, area) ? words : "";
}

/// Words on a patch of the cell's colour, so that the curve does not run through them.
void cell_text(drawing::Canvas& canvas, drawing::Point at, const std::string& words, double size,
               drawing::Colour fill, bool bold) {
  if (words.empty()) return;
  const drawing::Quoted shown = drawing::in_quotes(words);
  const double half_width = drawing::text_width(shown, size) / 2 + 0.3, half_height = 0.55 * size;
  canvas.patch({{at.x - half_width, at.y - half_height}, {at.x + half_width, at.y + half_height}},
               fill);
  canvas.text(at, shown, {.size = size, .colour = drawing::text_colour(fill), .bold = bold});
}

struct Words {
  std::string text;
  double size = value_size;
  bool bold = false;
};

/// Two lines where the place is high enough, else the first that is not empty.
void draw_words(drawing::Canvas& canvas, const drawing::Area& area, drawing::Colour fill,
                const Words& upper, const Words& lower) {
  const drawing::Point middle = area.centre();
  const double lift = std::min(area.height() / 4, 4.5);
  if (!upper.text.empty() && !lower.text.empty() && 2 * lift > 7) {
    cell_text(canvas, {middle.x, middle.y + lift}, upper.text, upper.size, fill, upper.bold);
    cell_text(canvas, {middle.x, middle.y - lift}, lower.text, lower.size, fill, lower.bold);
    return;
  }
  const Words& only = upper.text.empty() ? lower : upper;
  if (area.height() > only.size) cell_text(canvas, middle, only.text, only.size, fill, only.bold);
}

void draw_result(drawing::Canvas& canvas, const drawing::Area& area, const PhaseCell& cell,
                 const MapScale& scale) {
  const bool of_class = scale.quantity == MapQuantity::outcome;
  const std::optional<double> value = value_of(scale.quantity, cell);
  const drawing::Colour fill = of_class ? outcome_colour(cell.outcome)
                               : value  ? scale.colour(*value)
                                        : map_mark::pale;
  canvas.fill(area, fill);
  if (cell.stale) map_mark::stale(canvas, area, fill);
  if (cell.state == CellState::unsettled) map_mark::unsettled(canvas, area, fill);
  if (cell.smaller_eer) map_mark::smaller_eer(canvas, area);
  const Words letter{letter_text(cell, area), map_mark::letter_size, true};
  if (!of_class) {
    draw_words(canvas, area, fill, {value ? value_text(scale.quantity, *value, area) : "–"},
               letter);
    return;
  }
  Words share{"", value_size - 1};
  if (cell.class_share < 1) share.text = fmt::format("{:.0f}%", 100 * cell.class_share);
  if (!fits(share.text, share.size, area)) share.text.clear();
  draw_words(canvas, area, fill, letter, share);
}

}  // namespace

CellGrid::CellGrid(const PhaseDiagram& diagram) {
  std::vector<double> speeds, angles;
  for (const PhaseCell& cell : diagram.cells) {
    speeds.push_back(cell.v_imp_cm_per_s);
    angles.push_back(cell.theta_imp_deg);
  }
  v = statistics::map_axis(speeds), theta = statistics::map_axis(angles);
  cells.assign(v.at.size() * theta.at.size(), nullptr);
  for (const PhaseCell& cell : diagram.cells)
    cells[v.index(cell.v_imp_cm_per_s) + theta.index(cell.theta_imp_deg) * v.at.size()] = &cell;
}

drawing::Area CellGrid::area(const PanelFrame& frame, std::size_t i, std::size_t j) const {
  return {{frame.x(v.edges[i]), frame.y(theta.edges[j])},
          {frame.x(v.edges[i + 1]), frame.y(theta.edges[j + 1])}};
}

void draw_cells(drawing::Canvas& canvas, const CellGrid& grid, const PanelFrame& frame,
                const MapScale& scale) {
  for (std::size_t j = 0; j < grid.theta.at.size(); ++j)
    for (std::size_t i = 0; i < grid.v.at.size(); ++i) {
      const drawing::Area area = grid.area(frame, i, j);
      const PhaseCell* cell = grid.cells[i + j * grid.v.at.size()];
      if (cell == nullptr)
        map_mark::missing(canvas, area);
      else if (cell->has_result())
        draw_result(canvas, area, *cell, scale);
      else if (cell->state == CellState::failed)
        map_mark::failed(canvas, area);
      else
        map_mark::pending(canvas, area);
      canvas.outline(area, {255, 255, 255}, 0.5);
      if (cell != nullptr && cell->in_doubt) map_mark::in_doubt(canvas, area);
    }
}

}  // namespace eerie::diagrams
