#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/diagrams/phase_diagram.hpp"
#include "analysis/drawing/palette.hpp"
#include "analysis/drawing/script.hpp"

namespace eerie::diagrams {

struct QuantityName {
  MapQuantity quantity;
  std::string_view token;  ///< its word on the command line and in names of files
  drawing::Literal title;  ///< with unit, in gnuplot's markup
};
inline constexpr std::array<QuantityName, 7> quantity_names = {{
    {MapQuantity::b_over_a, "b/a", "b/a of the largest remnant"},
    {MapQuantity::c_over_a, "c/a", "c/a of the largest remnant"},
    {MapQuantity::m_lr, "m-lr", "M_{lr}\u00a0/\u00a0M_{total}"},
    {MapQuantity::period, "period", "spin period, largest remnant (h)"},
    {MapQuantity::outcome, "class", "most frequent outcome"},
    {MapQuantity::n_eer, "n-eer", "EERs per impact"},
    {MapQuantity::p_largest_eer, "p-eer", "P(largest remnant is an EER)"},
}};
const QuantityName& name_of(MapQuantity quantity);
/// The quantity with this token. Throws InputError, which lists the tokens, where there is none.
MapQuantity quantity_named(std::string_view token);

/// The value of a cell with a result. Nothing where the result has no such number, and for the
/// class.
std::optional<double> value_of(MapQuantity quantity, const PhaseCell& cell);
/// The value in words: "0.24", "9.4", "120".
std::string value_words(MapQuantity quantity, double value);

/// The fill of a class. The colours differ in every common form of colour blindness (Okabe & Ito
/// 2008).
drawing::Colour outcome_colour(std::string_view outcome);

/// Maps values to colours. b/a has its own colours, blue where remnants are extremely elongated.
/// Quantities that count EERs go from cream to blue, others from violet to yellow.
struct MapScale {
  MapQuantity quantity = MapQuantity::b_over_a;
  double low = 0, high = 1;
  bool logarithmic = false;
  std::vector<double> ticks = {0, 1};

  double part(double value) const;  ///< position between low and high, as a fraction
  drawing::Colour at_part(double part) const;
  drawing::Colour colour(double value) const { return at_part(part(value)); }
};

/// The scale for all these cells. Fractions go from 0 to 1. The period goes from one round number
/// to another, logarithmically where the longest is more than four times the shortest.
MapScale map_scale(MapQuantity quantity, const std::vector<PhaseCell>& cells);

}  // namespace eerie::diagrams
