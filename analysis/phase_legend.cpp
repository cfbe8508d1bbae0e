#include "analysis/phase_legend.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/outcome.hpp"
#include "analysis/remnants.hpp"

namespace eerie {

namespace map_mark {

void pending(Canvas& canvas, const Area& area) {
  canvas.fill(area, pale);
  canvas.hatch(area, grey, 2.4);
}

void failed(Canvas& canvas, const Area& area) {
  canvas.fill(area, {255, 255, 255});
  canvas.cross(area, failure);
}

void unsettled(Canvas& canvas, const Area& area) { canvas.hatch(area, umber, 4); }

void smaller_eer(Canvas& canvas, const Area& area) {
  const double side = std::min({6.0, area.width() / 2, area.height() / 2});
  const Point corner = area.high;
  canvas.polygon({corner, {corner.x - side, corner.y}, {corner.x, corner.y - side}}, eer);
}

void in_doubt(Canvas& canvas, const Area& area) {
  canvas.outline({{area.low.x + 1, area.low.y + 1}, {area.high.x - 1, area.high.y - 1}}, failure,
                 1.2);
}

std::string basis(const PhaseCell& cell) {
  const char letter = cell.fidelity == "sketch" ? 'k' : cell.fidelity == "survey" ? 'v' : 'p';
  return fmt::format("{}{}", letter, cell.seeds);
}

}  // namespace map_mark

namespace {

constexpr double words_size = 6, row_height = 9.5, symbol_width = 11, gap = 8;

bool has_result(const PhaseCell& cell) {
  return cell.state == CellState::done || cell.state == CellState::unsettled;
}

}  // namespace

PhaseLegend::PhaseLegend(const PhaseDiagram& diagram, double width_pt) {
  const auto any = [&](auto test) { return std::ranges::any_of(diagram.cells, test); };
  if (diagram.threshold_cm_per_s)
    entries_.push_back(
        {Mark::curve, "", fmt::format("v sin θ = {:g} cm/s", *diagram.threshold_cm_per_s)});
  entries_.push_back({Mark::blue, "", "EER (b/a < 0.3)"});
  if (any([](const PhaseCell& c) {
        return has_result(c) && c.eer && c.b_over_a >= eer_max_b_over_a;
      }))
    entries_.push_back({Mark::corner, "", "a smaller remnant is an EER"});
  for (const OutcomeName& row : outcome_names)
    if (any([&](const PhaseCell& c) { return has_result(c) && c.outcome == row.name; }))
      entries_.push_back({Mark::letter, std::string(row.short_name), std::string(row.name)});
  for (const char* fidelity : {"sketch", "survey", "paper"})
    if (any([&](const PhaseCell& c) { return c.fidelity == fidelity; }))
      entries_.push_back({Mark::letter, map_mark::basis({.fidelity = fidelity, .seeds = 4}),
                          fmt::format("4 seeds, {}", fidelity)});
  if (any([](const PhaseCell& c) { return c.in_doubt; }))
    entries_.push_back({Mark::doubt, "", "in doubt"});
  if (any([](const PhaseCell& c) { return c.state == CellState::unsettled; }))
    entries_.push_back({Mark::unsettled, "", "unsettled: pieces will meet again"});
  if (any([](const PhaseCell& c) { return c.state == CellState::failed; }))
    entries_.push_back({Mark::failed, "", "failed"});
  if (any([](const PhaseCell& c) { return c.state == CellState::pending; }))
    entries_.push_back({Mark::pending, "", "not run yet"});
  double x = 0;
  int row = 0;
  for (Entry& entry : entries_) {
    const double width = symbol_width + text_width(entry.words, words_size);
    if (x > 0 && x + width > width_pt) x = 0, ++row;
    entry.x = x, entry.row = row;
    x += width + gap;
  }
}

double PhaseLegend::height_pt() const { return row_height * (entries_.back().row + 1); }

void PhaseLegend::draw(Canvas& canvas, Point upper_left) const {
  for (const Entry& entry : entries_) {
    const Point at{upper_left.x + entry.x, upper_left.y - row_height * (entry.row + 0.5)};
    const Area box{{at.x, at.y - 3}, {at.x + 8, at.y + 3}};
    switch (entry.mark) {
      case Mark::letter:
        canvas.text(box.centre(), entry.letter,
                    {.size = words_size, .colour = map_mark::ink, .bold = true});
        break;
      case Mark::curve:
        canvas.line({box.low.x, at.y}, {box.high.x, at.y}, map_mark::ink, 1.2);
        break;
      case Mark::blue:
        canvas.fill(box, b_over_a_colour(0.15));
        break;
      case Mark::corner:
        canvas.fill(box, b_over_a_colour(0.8));
        map_mark::smaller_eer(canvas, box);
        break;
      case Mark::unsettled:
        canvas.fill(box, b_over_a_colour(0.8));
        canvas.hatch(box, map_mark::umber, 2.4);
        break;
      case Mark::pending:
        map_mark::pending(canvas, box);
        break;
      case Mark::failed:
        map_mark::failed(canvas, box);
        break;
      case Mark::doubt:
        canvas.fill(box, b_over_a_colour(0.8));
        map_mark::in_doubt(canvas,
                           {{box.low.x - 1, box.low.y - 1}, {box.high.x + 1, box.high.y + 1}});
        break;
    }
    if (entry.mark != Mark::letter && entry.mark != Mark::curve)
      canvas.outline(box, map_mark::grey, 0.3);
    canvas.text({at.x + symbol_width, at.y}, entry.words,
                {.size = words_size, .colour = map_mark::ink, .align = Align::left});
  }
}

}  // namespace eerie
