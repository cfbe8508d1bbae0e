#include "analysis/diagrams/phase_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/diagrams/phase_cells.hpp"
#include "analysis/remnants/outcome.hpp"
#include "solver/base/constants.hpp"

namespace eerie::diagrams {

namespace {

using drawing::Area, drawing::Point;

constexpr double margin = 0.3, curve_half_width = 1.5;

/// The part of cells with a result that have room for what `line_of` makes of them (empty:
/// nothing).
template <class LineOf>
double part_that_fits(const CellGrid& grid, const PanelFrame& frame, LineOf line_of) {
  int cells = 0, fit = 0;
  for (std::size_t k = 0; k < grid.cells.size(); ++k) {
    const PhaseCell* cell = grid.cells[k];
    if (cell == nullptr || !cell->has_result()) continue;
    const Area area = grid.area(frame, k % grid.v.at.size(), k / grid.v.at.size());
    ++cells;
    if (line_of(*cell).width() <= area.width()) ++fit;
  }
  return cells == 0 ? 1 : static_cast<double>(fit) / cells;
}

Area around(Point at, const CellLine& line) {
  const double w = line.width() / 2, h = line.height() / 2;
  return {{at.x - w, at.y - h}, {at.x + w, at.y + h}};
}

bool overlap(const Area& a, const Area& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

/// Lines below each other, centred on a point.
std::vector<Point> stack(Point centre, std::span<const CellLine> lines) {
  double height = 0;
  for (const CellLine& line : lines) height += line.height();
  std::vector<Point> places;
  double top = centre.y + height / 2;
  for (const CellLine& line : lines) {
    places.push_back({centre.x, top - line.height() / 2});
    top -= line.height();
  }
  return places;
}

/// How far something may move from the middle of a cell.
Point room_for(const Area& cell, double width, double height) {
  return {std::max(0.0, (cell.width() - width) / 2 - 0.5),
          std::max(0.0, (cell.height() - height) / 2 - 0.5)};
}

Point room_for_stack(const Area& cell, std::span<const CellLine> lines) {
  double width = 0, height = 0;
  for (const CellLine& line : lines) width = std::max(width, line.width()), height += line.height();
  return room_for(cell, width, height);
}

/// All placings worth a try, the best first. The curve falls from left to right: what is free lies
/// above right or below left of it.
std::vector<std::vector<Point>> placings(const Area& cell, std::span<const CellLine> lines) {
  const Point c = cell.centre(), room = room_for_stack(cell, lines);
  std::vector<std::vector<Point>> all = {stack(c, lines)};
  for (const double part : {0.4, 0.7, 1.0})
    for (const auto& [x, y] : {std::pair{0, 1}, {0, -1}, {1, 0}, {-1, 0}, {1, 1}, {-1, -1}})
      all.push_back(stack({c.x + part * x * room.x, c.y + part * y * room.y}, lines));
  if (lines.size() != 2) return all;
  const Point upper = room_for(cell, lines[0].width(), lines[0].height()),
              lower = room_for(cell, lines[1].width(), lines[1].height());
  for (const double part : {0.5, 1.0})
    all.push_back({{c.x + part * upper.x, c.y + upper.y}, {c.x - part * lower.x, c.y - lower.y}});
  // The wider line may have room on the other side alone.
  all.push_back({{c.x - upper.x, c.y - upper.y}, {c.x + lower.x, c.y + lower.y}});
  return all;
}

}  // namespace

double CellLine::width() const {
  return drawing::text_width(drawing::in_quotes(text), size, bold) + 2 * margin;
}
double CellLine::height() const { return text.empty() ? 0 : 1.1 * size; }

std::string number_words(MapQuantity quantity, double value, bool short_numbers) {
  const std::string words = value_words(quantity, value);
  if (!short_numbers) return words;
  if (words.starts_with("0.")) return words.substr(1);
  return words == "1.00" ? "1.0" : words;
}

std::string letter_words(const PhaseCell& cell) {
  const auto row =
      std::ranges::find(remnants::outcome_names, cell.outcome, &remnants::OutcomeName::name);
  return std::string(row->short_name) + (cell.fidelity.empty() ? "" : " " + map_mark::basis(cell));
}

CellWords cell_words(const CellGrid& grid, const PanelFrame& frame, MapQuantity quantity,
                     bool letters) {
  CellWords words{.letters = letters};
  struct Form {
    bool short_numbers;
    double size;
  };
  for (const Form& form : {Form{false, 6}, {true, 6}, {true, 5.2}, {true, 4.5}}) {
    words.short_numbers = form.short_numbers, words.number_size = form.size;
    const double part = part_that_fits(grid, frame, [&](const PhaseCell& cell) {
      const std::optional<double> value = value_of(quantity, cell);
      return CellLine{value ? number_words(quantity, *value, form.short_numbers) : "", form.size};
    });
    words.numbers = part >= 0.5;
    if (part == 1) break;
  }
  for (const double size : {5.5, 5.0, 4.5}) {
    words.letter_size = size;
    const double part = part_that_fits(grid, frame, [&](const PhaseCell& cell) {
      return CellLine{letter_words(cell), size, true};
    });
    if (part == 1) break;
  }
  return words;
}

bool curve_crosses(const Area& area, const PanelFrame& frame, double constant) {
  // v sin(theta) rises with both, up to 90 deg: its extremes lie in two corners.
  const auto value = [&](Point p) {
    const double v =
        frame.v_low + (frame.v_high - frame.v_low) * (p.x - frame.area.low.x) / frame.area.width();
    const double theta = frame.theta_low + (frame.theta_high - frame.theta_low) *
                                               (p.y - frame.area.low.y) / frame.area.height();
    return v * std::sin(radians(std::clamp(theta, 0.0, 90.0)));
  };
  return value(area.low) <= constant && constant <= value(area.high);
}

std::vector<Point> places_of_words(const Area& cell, std::span<const CellLine> lines,
                                   const PanelFrame& frame, std::optional<double> curve,
                                   std::optional<Area> taken) {
  const auto is_free = [&](const std::vector<Point>& places) {
    for (std::size_t k = 0; k < lines.size(); ++k) {
      const Area box = around(places[k], lines[k]);
      const Area wide{{box.low.x - curve_half_width, box.low.y - curve_half_width},
                      {box.high.x + curve_half_width, box.high.y + curve_half_width}};
      if (curve && curve_crosses(wide, frame, *curve)) return false;
      if (taken && overlap(box, *taken)) return false;
    }
    return true;
  };
  const auto all = placings(cell, lines);
  const auto found = std::ranges::find_if(all, is_free);
  return found == all.end() ? all.front() : *found;
}

}  // namespace eerie::diagrams
