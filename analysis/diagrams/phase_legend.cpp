#include "analysis/diagrams/phase_legend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "analysis/diagrams/phase_cells.hpp"
#include "analysis/remnants/outcome.hpp"
#include "analysis/remnants/remnants.hpp"

namespace eerie::diagrams {

namespace {

constexpr double words_size = 6, row_height = 9.5, symbol_width = 11, gap = 8;
constexpr drawing::Colour sand{0xf6, 0xdf, 0xb4};

/// Whether some cell of the figure passes.
template <class Test>
bool any(const PhaseFigure& figure, Test test) {
  return std::ranges::any_of(
      figure.diagrams, [&](const PhaseDiagram& d) { return std::ranges::any_of(d.cells, test); });
}

/// The number of seeds that most results of a fidelity have; 0 where it has none.
std::size_t usual_seeds(const PhaseFigure& figure, std::string_view fidelity) {
  std::map<std::size_t, int> cells;
  for (const PhaseDiagram& d : figure.diagrams)
    for (const PhaseCell& c : d.cells)
      if (c.has_result() && c.fidelity == fidelity) ++cells[c.seeds];
  const auto most = std::ranges::max_element(cells, {}, [](const auto& x) { return x.second; });
  return most == cells.end() ? 0 : most->first;
}

bool shows(const PhaseFigure& figure, MapQuantity quantity) {
  return std::ranges::count(figure.quantities, quantity) > 0;
}

bool lacks_a_value(const PhaseFigure& figure) {
  return any(figure, [&](const PhaseCell& c) {
    return c.has_result() && std::ranges::any_of(figure.quantities, [&](MapQuantity quantity) {
             return quantity != MapQuantity::outcome && !value_of(quantity, c);
           });
  });
}

}  // namespace

PhaseLegend::PhaseLegend(const PhaseFigure& figure, double width_pt, bool letters,
                         const std::vector<drawing::Quoted>& left_out) {
  add_curve(figure);
  add_borders(figure);
  const bool blue = any(figure, [](const PhaseCell& c) {
    return c.has_result() && c.b_over_a && *c.b_over_a < remnants::eer_max_b_over_a;
  });
  if (blue && shows(figure, MapQuantity::b_over_a)) add(Mark::blue, {}, "EER (b/a < 0.3)");
  if (any(figure, [](const PhaseCell& c) { return c.has_result() && c.smaller_eer; }))
    add(Mark::corner, {}, "a smaller remnant is an EER");
  add_classes(figure, letters);
  add_states(figure, letters);
  for (const drawing::Quoted& name : left_out)
    entries_.push_back({Mark::none, {}, name + drawing::in_quotes(": not run yet")});
  double x = 0;
  int row = 0;
  for (Entry& entry : entries_) {
    const double width = symbol_of(entry) + drawing::text_width(entry.words, words_size);
    if (x > 0 && x + width > width_pt) x = 0, ++row;
    entry.x = x, entry.row = row;
    x += width + gap;
  }
}

double PhaseLegend::symbol_of(const Entry& entry) {
  return entry.mark == Mark::none ? 0 : symbol_width;
}

void PhaseLegend::add(Mark mark, std::string_view letter, std::string_view words,
                      std::optional<drawing::Colour> fill) {
  entries_.push_back({mark, drawing::in_quotes(letter), drawing::in_quotes(words), fill});
}

void PhaseLegend::add_curve(const PhaseFigure& figure) {
  std::vector<double> constants;
  std::string source;
  for (const PhaseDiagram& d : figure.diagrams)
    if (d.threshold_cm_per_s) {
      constants.push_back(*d.threshold_cm_per_s);
      source = d.threshold_source;
    }
  if (constants.empty()) return;
  const bool same = std::ranges::count(constants, constants.front()) == std::ssize(constants);
  add(Mark::curve, {},
      source + (same ? fmt::format(": v sin θ = {:.3g} cm/s", constants.front())
                     : ": v sin θ as in the panel's title"));
}

void PhaseLegend::add_borders(const PhaseFigure& figure) {
  if (!shows(figure, MapQuantity::p_largest_eer) ||
      std::ranges::none_of(figure.diagrams,
                           [](const PhaseDiagram& d) { return d.borders.has_value(); }))
    return;
  add(Mark::border, {}, "fitted: P = 1/2");
  add(Mark::border_ends, {}, "its 68 % interval");
}

void PhaseLegend::add_classes(const PhaseFigure& figure, bool letters) {
  const bool coloured = shows(figure, MapQuantity::outcome);
  for (const remnants::OutcomeName& row : remnants::outcome_names)
    if ((letters || coloured) &&
        any(figure, [&](const PhaseCell& c) { return c.has_result() && c.outcome == row.name; }))
      add(Mark::letter, row.short_name, row.name,
          coloured ? std::optional(outcome_colour(row.name)) : std::nullopt);
  if (coloured &&
      any(figure, [](const PhaseCell& c) { return c.has_result() && c.class_share < 1; }))
    add(Mark::letter, "%", "of the seeds, where they differ");
}

void PhaseLegend::add_states(const PhaseFigure& figure, bool letters) {
  for (const char* fidelity : {"sketch", "survey", "standard", "fine", "paper"})
    if (const std::size_t seeds = usual_seeds(figure, fidelity); letters && seeds > 0)
      add(Mark::letter, map_mark::basis({.fidelity = fidelity, .seeds = seeds}),
          fmt::format("{}, {} seed{}", fidelity, seeds, seeds == 1 ? "" : "s"));
  if (any(figure, [](const PhaseCell& c) { return c.in_doubt; })) add(Mark::doubt, {}, "in doubt");
  if (any(figure, [](const PhaseCell& c) { return c.state == CellState::unsettled; }))
    add(Mark::unsettled, {}, "unsettled: pieces will meet again");
  if (any(figure, [](const PhaseCell& c) { return c.has_result() && c.stale; }))
    add(Mark::stale, {}, "stale: of another solver version");
  if (lacks_a_value(figure)) add(Mark::letter, "–", "has no such number");
  if (any(figure, [](const PhaseCell& c) { return c.state == CellState::failed; }))
    add(Mark::failed, {}, "failed");
  if (any(figure, [](const PhaseCell& c) { return c.state == CellState::pending; }))
    add(Mark::pending, {}, "not run yet");
  if (std::ranges::any_of(figure.diagrams, [](const PhaseDiagram& d) {
        return std::ranges::count(CellGrid(d).cells, nullptr) > 0;
      }))
    add(Mark::missing, {}, "no job");
}

double PhaseLegend::height_pt() const {
  return entries_.empty() ? 0 : row_height * (entries_.back().row + 1);
}

void PhaseLegend::draw_mark(drawing::Canvas& canvas, const Entry& entry, const drawing::Area& box) {
  switch (entry.mark) {
    case Mark::none:
      return;
    case Mark::letter:
      if (entry.fill) canvas.fill(box, *entry.fill);
      canvas.text(box.centre(), entry.letter,
                  {.size = words_size, .colour = map_mark::ink, .bold = true});
      return;
    case Mark::curve:
      canvas.line({box.low.x, box.centre().y}, {box.high.x, box.centre().y}, map_mark::ink, 1.2);
      return;
    case Mark::border:
    case Mark::border_ends:
      canvas.line({box.low.x, box.centre().y}, {box.high.x, box.centre().y}, map_mark::border,
                  entry.mark == Mark::border ? 1.4 : 0.5);
      return;
    case Mark::blue:
      canvas.fill(box, drawing::b_over_a_colour(0.15));
      break;
    case Mark::corner:
      canvas.fill(box, sand);
      map_mark::smaller_eer(canvas, box);
      break;
    case Mark::unsettled:
      canvas.fill(box, sand);
      map_mark::unsettled(canvas, box, sand, 2.4);
      break;
    case Mark::stale:
      canvas.fill(box, sand);
      map_mark::stale(canvas, box, sand, 2);
      break;
    case Mark::missing:
      map_mark::missing(canvas, box);
      break;
    case Mark::pending:
      map_mark::pending(canvas, box);
      break;
    case Mark::failed:
      map_mark::failed(canvas, box);
      break;
    case Mark::doubt:
      canvas.fill(box, sand);
      map_mark::in_doubt(canvas,
                         {{box.low.x - 1, box.low.y - 1}, {box.high.x + 1, box.high.y + 1}});
      break;
  }
  canvas.outline(box, map_mark::grey, 0.3);
}

void PhaseLegend::draw(drawing::Canvas& canvas, drawing::Point upper_left) const {
  for (const Entry& entry : entries_) {
    const drawing::Point at{upper_left.x + entry.x, upper_left.y - row_height * (entry.row + 0.5)};
    draw_mark(canvas, entry, {{at.x, at.y - 3}, {at.x + 8, at.y + 3}});
    canvas.text({at.x + symbol_of(entry), at.y}, entry.words,
                {.size = words_size, .colour = map_mark::ink, .align = drawing::Align::left});
  }
}

}  // namespace eerie::diagrams
