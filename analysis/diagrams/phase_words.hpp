#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/diagrams/map_quantity.hpp"
#include "analysis/drawing/canvas.hpp"

namespace eerie::diagrams {

struct CellGrid;
struct PanelFrame;

/// How the words of a panel are set, alike in all its cells.
struct CellWords {
  bool letters = true;                        ///< cells show their class
  bool numbers = true;                        ///< cells show their number
  bool fractions_only = false;                ///< ... but 0 and 1, which the colour tells
  bool short_numbers = false;                 ///< ".24" and "1.0" instead of "0.24" and "1.00"
  double number_size = 6, letter_size = 5.5;  ///< points
  /// Words keep away from the curve v sin(theta) = this, cm/s.
  std::optional<double> curve = {};
};

/// The largest type, and the longest form of numbers, for which all cells of the panel have room.
/// At the smallest type some cells may still lack it; they stay without words. Where most of them
/// lack it for numbers, none has a number.
CellWords cell_words(const CellGrid& grid, const PanelFrame& frame, MapQuantity quantity,
                     bool letters);

std::string number_words(MapQuantity quantity, double value, bool short_numbers);
/// The letter of the class, and what the result rests on where cells differ.
std::string letter_words(const PhaseCell& cell);

/// A line of words in a cell.
struct CellLine {
  std::string text;
  double size = 6;
  bool bold = false;
  double width() const;   ///< points, with its margin
  double height() const;  ///< points, with its margin
};

/// Where lines stand in a cell, from the top down. Nothing lies on the curve or on `taken`, where
/// the cell has such a place: the middle if it is free, else aside, else one line on each side of
/// the curve. Otherwise they stand in the middle.
std::vector<drawing::Point> places_of_words(const drawing::Area& cell,
                                            std::span<const CellLine> lines,
                                            const PanelFrame& frame, std::optional<double> curve,
                                            std::optional<drawing::Area> taken = {});

/// Whether the curve v sin(theta) = constant passes through an area of the page.
bool curve_crosses(const drawing::Area& area, const PanelFrame& frame, double constant);

}  // namespace eerie::diagrams
