#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/drawing/script.hpp"

namespace eerie::figures {

/// A row of a table whose cells have colours.
struct MatrixRow {
  struct Cell {
    double b_over_a = 0;  ///< decides its colour, as in maps
    std::string text;     ///< the text of the cell
  };
  std::string label;
  std::vector<std::optional<Cell>> cells;  ///< one per column
};

/// Rows that share a property, under its name.
struct MatrixGroup {
  std::string name;
  std::vector<MatrixRow> rows;
};

struct MatrixFigure {
  std::vector<std::string> columns;
  std::vector<MatrixGroup> groups;
  std::string caption;  ///< explains the text of the cells
  std::string title = {};
  std::vector<std::string> notes = {};  ///< further lines below, such as what columns are
};

/// The gnuplot commands for the figure, without the terminal line. Throws InputError where there is
/// no row or no column.
drawing::Script matrix_script(const MatrixFigure& figure);

/// Draws the figure at `path`. The extension names the format: .svg, .png or .pdf. Throws
/// InputError and EnvironmentError as run_gnuplot() does.
void draw_matrix(const std::filesystem::path& path, const MatrixFigure& figure);

}  // namespace eerie::figures
