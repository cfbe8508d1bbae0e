#include "analysis/diagrams/map_quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/remnants/outcome.hpp"
#include "analysis/remnants/remnants.hpp"
#include "analysis/statistics/map_axis.hpp"
#include "solver/base/error.hpp"

namespace eerie::diagrams {

namespace {

constexpr double wide = 4;  // longest over shortest period

bool counts_eers(MapQuantity quantity) {
  return quantity == MapQuantity::n_eer || quantity == MapQuantity::p_largest_eer;
}

/// 1, 2 or 5 times a power of ten: the greatest up to `value`, or the least from it.
double round_below(double value) {
  const double power = std::pow(10, std::floor(std::log10(value) + 1e-12));
  const double factor = value / power * (1 + 1e-12);
  return power * (factor >= 5 ? 5 : factor >= 2 ? 2 : 1);
}
double round_above(double value) {
  const double below = round_below(value);
  if (below >= value * (1 - 1e-12)) return below;
  return round_below(below * 2.5 * (1 + 1e-12));
}

/// From round number to round number, so that the ends have ticks.
void fit_linear(MapScale& scale, double least, double most) {
  if (most == least) least *= 0.5, most *= 1.5;
  const double step = round_above((most - least) / 6);
  const double first = std::floor(least / step + 1e-9), last = std::ceil(most / step - 1e-9);
  scale.low = first * step, scale.high = last * step;
  scale.ticks.clear();
  for (double k = first; k <= last; ++k) scale.ticks.push_back(k * step);
}

void fit_logarithmic(MapScale& scale, double least, double most) {
  scale.logarithmic = true;
  scale.low = round_below(least), scale.high = round_above(most);
  scale.ticks = {scale.low};
  while (scale.ticks.back() < scale.high * (1 - 1e-9))
    scale.ticks.push_back(round_above(scale.ticks.back() * 1.5));
  if (scale.ticks.size() <= 8) return;
  std::erase_if(scale.ticks, [](double tick) {
    return std::abs(std::log10(tick) - std::round(std::log10(tick))) > 1e-6;
  });
}

}  // namespace

const QuantityName& name_of(MapQuantity quantity) {
  return *std::ranges::find(quantity_names, quantity, &QuantityName::quantity);
}

MapQuantity quantity_named(std::string_view token) {
  std::string known;
  for (const QuantityName& row : quantity_names) {
    if (row.token == token) return row.quantity;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", row.token);
  }
  throw InputError(fmt::format("--quantity {}: must be one of {}", token, known));
}

std::optional<double> value_of(MapQuantity quantity, const PhaseCell& cell) {
  switch (quantity) {
    case MapQuantity::b_over_a:
      return cell.b_over_a;
    case MapQuantity::c_over_a:
      return cell.c_over_a;
    case MapQuantity::m_lr:
      return cell.m_lr_over_m_total;
    case MapQuantity::period:
      return cell.period_h;
    case MapQuantity::n_eer:
      return cell.n_eer;
    case MapQuantity::p_largest_eer:
      return cell.p_largest_eer;
    case MapQuantity::outcome:
      return std::nullopt;
  }
  throw std::logic_error("unknown quantity of a map");
}

std::string value_words(MapQuantity quantity, double value) {
  if (quantity == MapQuantity::period)
    return value < 9.95 ? fmt::format("{:.1f}", value) : fmt::format("{:.0f}", value);
  if (counts_eers(quantity) && value == std::round(value)) return fmt::format("{:.0f}", value);
  return fmt::format("{:.2f}", value);
}

drawing::Colour outcome_colour(std::string_view outcome) {
  switch (remnants::outcome_named(outcome).value()) {
    case remnants::OutcomeClass::perfect_merging:
      return {0x56, 0xb4, 0xe9};
    case remnants::OutcomeClass::graze_and_merge:
      return {0x00, 0x9e, 0x73};
    case remnants::OutcomeClass::partial_accretion:
      return {0xf0, 0xe4, 0x42};
    case remnants::OutcomeClass::hit_and_run:
      return {0xe6, 0x9f, 0x00};
    case remnants::OutcomeClass::erosion:
      return {0xcc, 0x79, 0xa7};
    case remnants::OutcomeClass::catastrophic_disruption:
      return {0xd5, 0x5e, 0x00};
  }
  throw std::logic_error("unknown outcome class");
}

double MapScale::part(double value) const {
  return logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
}

drawing::Colour MapScale::at_part(double part) const {
  if (quantity == MapQuantity::b_over_a) return drawing::b_over_a_colour(part);
  return counts_eers(quantity) ? drawing::eer_count_colour(part) : drawing::quantity_colour(part);
}

MapScale map_scale(MapQuantity quantity, const std::vector<PhaseCell>& cells) {
  MapScale scale{quantity};
  if (quantity == MapQuantity::b_over_a) scale.ticks = {0, remnants::eer_max_b_over_a, 0.5, 1};
  if (quantity == MapQuantity::c_over_a || quantity == MapQuantity::m_lr ||
      quantity == MapQuantity::p_largest_eer)
    scale.ticks = {0, 0.5, 1};
  std::vector<double> values;
  for (const PhaseCell& cell : cells)
    if (const auto value = value_of(quantity, cell); value && cell.has_result())
      values.push_back(*value);
  if (values.empty()) return scale;
  const auto [least, most] = std::ranges::minmax(values);
  if (quantity == MapQuantity::n_eer) {
    scale.high = std::max(1.0, std::ceil(most));
    scale.ticks = statistics::round_ticks(0, scale.high, 7);
  }
  if (quantity == MapQuantity::period) {
    if (least > 0 && most > wide * least)
      fit_logarithmic(scale, least, most);
    else
      fit_linear(scale, least, most);
  }
  return scale;
}

}  // namespace eerie::diagrams
