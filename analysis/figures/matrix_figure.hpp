#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/drawing/script.hpp"

namespace eerie::figures {

/// A row of a table that is read by its colours.
struct MatrixRow {
  struct Cell {
    double b_over_a = 0;  ///< its colour, that of maps
    std::string text;     ///< what stands in it
  };
  std::string label;
  std::vector<std::optional<Cell>> cells;  ///< one per column
};

/// Rows under the name of what they share.
struct MatrixGroup {
  std::string name;
  std::vector<MatrixRow> rows;
};

struct MatrixFigure {
  std::vector<std::string> columns;
  std::vector<MatrixGroup> groups;
  std::string caption;  ///< says what stands in the cells
};

/// gnuplot's commands for the figure, without its terminal. Throws InputError where there is no
/// row or no column.
drawing::Script matrix_script(const MatrixFigure& figure);

/// Draws it at `path`; the extension decides: .svg, .png, .pdf. Throws InputError and
/// EnvironmentError as run_gnuplot() does.
void draw_matrix(const std::filesystem::path& path, const MatrixFigure& figure);

}  // namespace eerie::figures
