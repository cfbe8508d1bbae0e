#include "analysis/diagrams/phase_cells.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace eerie::diagrams {

namespace {

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

drawing::Area corner_of(const drawing::Area& area) {
  const double side = std::min({6.0, area.width() / 2, area.height() / 2});
  return {{area.high.x - side, area.high.y - side}, area.high};
}

void smaller_eer(drawing::Canvas& canvas, const drawing::Area& area) {
  const drawing::Area corner = corner_of(area);
  const drawing::Point left{corner.low.x, corner.high.y}, down{corner.high.x, corner.low.y};
  canvas.polygon({corner.high, left, down}, eer);
  canvas.line(left, down, {255, 255, 255}, 0.6);  // it may lie on blue
}

void in_doubt(drawing::Canvas& canvas, const drawing::Area& area) {
  canvas.outline({{area.low.x + 1, area.low.y + 1}, {area.high.x - 1, area.high.y - 1}}, failure,
                 1.2);
}

std::string basis(const PhaseCell& cell) {
  const bool initial_is_taken = cell.fidelity == "sketch" || cell.fidelity == "survey";
  const char letter = !initial_is_taken           ? cell.fidelity.front()
                      : cell.fidelity == "sketch" ? 'k'
                                                  : 'v';
  return fmt::format("{}{}", letter, cell.seeds);
}

}  // namespace map_mark

namespace {

/// Words on a patch of the cell's colour, so that neither hatches nor the curve run through them.
void cell_text(drawing::Canvas& canvas, drawing::Point at, const CellLine& line,
               drawing::Colour fill) {
  const double half_width = line.width() / 2, half_height = line.height() / 2;
  canvas.patch({{at.x - half_width, at.y - half_height}, {at.x + half_width, at.y + half_height}},
               fill);
  canvas.text(at, drawing::in_quotes(line.text),
              {.size = line.size, .colour = drawing::text_colour(fill), .bold = line.bold});
}

/// What a panel's cells share.
struct CellLook {
  const PanelFrame& frame;
  const MapScale& scale;
  const CellWords& words;
};

/// The lines of a cell that have room in it, from the top down.
std::vector<CellLine> lines_of(const drawing::Area& area, const PhaseCell& cell,
                               const CellLook& look) {
  const CellWords& words = look.words;
  const MapQuantity quantity = look.scale.quantity;
  const std::optional<double> value = value_of(quantity, cell);
  const CellLine letter{words.letters ? letter_words(cell) : "", words.letter_size, true};
  std::vector<CellLine> lines;
  if (quantity == MapQuantity::outcome)
    lines = {letter,
             {cell.class_share < 1 ? fmt::format("{:.0f}%", 100 * cell.class_share) : "",
              words.letter_size - 0.5}};
  else
    lines = {{!words.numbers || (words.fractions_only && (value == 0.0 || value == 1.0)) ? ""
              : value ? number_words(quantity, *value, words.short_numbers)
                      : "–",
              words.number_size},
             letter};
  std::erase_if(lines, [&](const CellLine& line) {
    return line.text.empty() || line.width() > area.width() || line.height() > area.height();
  });
  if (lines.size() == 2 && lines[0].height() + lines[1].height() > area.height()) lines.pop_back();
  return lines;
}

void draw_result(drawing::Canvas& canvas, const drawing::Area& area, const PhaseCell& cell,
                 const CellLook& look) {
  const MapScale& scale = look.scale;
  const std::optional<double> value = value_of(scale.quantity, cell);
  const drawing::Colour fill = scale.quantity == MapQuantity::outcome ? outcome_colour(cell.outcome)
                               : value                                ? scale.colour(*value)
                                                                      : map_mark::pale;
  canvas.fill(area, fill);
  if (cell.stale) map_mark::stale(canvas, area, fill);
  if (cell.state == CellState::unsettled) map_mark::unsettled(canvas, area, fill);
  if (cell.smaller_eer) map_mark::smaller_eer(canvas, area);
  const std::vector<CellLine> lines = lines_of(area, cell, look);
  const auto corner = cell.smaller_eer ? std::optional(map_mark::corner_of(area)) : std::nullopt;
  const auto places = places_of_words(area, lines, look.frame, look.words.curve, corner);
  for (std::size_t k = 0; k < lines.size(); ++k) cell_text(canvas, places[k], lines[k], fill);
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
                const MapScale& scale, const CellWords& words) {
  for (std::size_t j = 0; j < grid.theta.at.size(); ++j)
    for (std::size_t i = 0; i < grid.v.at.size(); ++i) {
      const drawing::Area area = grid.area(frame, i, j);
      const PhaseCell* cell = grid.cells[i + j * grid.v.at.size()];
      if (cell == nullptr)
        map_mark::missing(canvas, area);
      else if (cell->has_result())
        draw_result(canvas, area, *cell, {frame, scale, words});
      else if (cell->state == CellState::failed)
        map_mark::failed(canvas, area);
      else
        map_mark::pending(canvas, area);
      canvas.outline(area, {255, 255, 255}, 0.5);
      if (cell != nullptr && cell->in_doubt) map_mark::in_doubt(canvas, area);
    }
}

}  // namespace eerie::diagrams
