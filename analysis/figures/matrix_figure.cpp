#include "analysis/figures/matrix_figure.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/drawing/canvas.hpp"
#include "analysis/drawing/gnuplot.hpp"
#include "solver/base/error.hpp"

namespace eerie::figures {

namespace {

using drawing::in_quotes;

constexpr double row_pt = 10, cell_pt = 33, name_pt = 13, head_pt = 14, margin_pt = 6,
                 indent_pt = 6, label_size = 6, title_pt = 13, title_size = 7, cell_size = 5.5,
                 caption_pt = 9, gap_pt = 6;
constexpr drawing::Colour ink{0x1a, 0x1a, 0x1a}, grey{0x60, 0x60, 0x60};

/// The lines below the table.
std::vector<std::string> below(const MatrixFigure& figure) {
  std::vector<std::string> lines = figure.notes;
  if (!figure.caption.empty()) lines.insert(lines.begin(), figure.caption);
  return lines;
}

/// Where rows and columns lie on the page.
struct Layout {
  double label_pt = 0, width = 0, height = 0;

  explicit Layout(const MatrixFigure& figure) {
    height = 2 * margin_pt + head_pt + (figure.title.empty() ? 0 : title_pt) +
             caption_pt * static_cast<double>(below(figure).size());
    for (const MatrixGroup& group : figure.groups) {
      height +=
          (group.name.empty() ? 0 : name_pt) + row_pt * static_cast<double>(group.rows.size());
      label_pt = std::max(label_pt, drawing::text_width(in_quotes(group.name), label_size));
      for (const MatrixRow& row : group.rows)
        label_pt =
            std::max(label_pt, indent_pt + drawing::text_width(in_quotes(row.label), label_size));
    }
    width = margin_pt + left_of(figure.columns.size());
    for (const std::string& line : below(figure))
      width = std::max(width, 2 * margin_pt + drawing::text_width(in_quotes(line), label_size));
    width =
        std::max(width, 2 * margin_pt + drawing::text_width(in_quotes(figure.title), title_size));
  }

  double left_of(std::size_t column) const {
    return margin_pt + label_pt + gap_pt + cell_pt * static_cast<double>(column);
  }
  drawing::Area cell(std::size_t column, double top) const {
    return {{left_of(column), top - row_pt}, {left_of(column) + cell_pt, top}};
  }
};

void draw_row(drawing::Canvas& canvas, const Layout& page, const MatrixRow& row, double indent,
              double top) {
  canvas.text({margin_pt + indent, top - row_pt / 2}, in_quotes(row.label),
              {.size = label_size, .colour = ink, .align = drawing::Align::left});
  for (std::size_t c = 0; c < row.cells.size(); ++c) {
    if (!row.cells[c]) continue;
    const drawing::Colour fill = drawing::b_over_a_colour(row.cells[c]->b_over_a);
    const drawing::Area area = page.cell(c, top);
    canvas.fill(area, fill);
    canvas.text(area.centre(), in_quotes(row.cells[c]->text),
                {.size = cell_size, .colour = drawing::text_colour(fill)});
  }
}

drawing::Canvas draw(const MatrixFigure& figure, const Layout& page) {
  drawing::Canvas canvas(page.width, page.height);
  double top = page.height - margin_pt;
  if (!figure.title.empty()) {
    canvas.text({margin_pt, top - title_pt / 2}, in_quotes(figure.title),
                {.size = title_size, .colour = ink, .align = drawing::Align::left});
    top -= title_pt;
  }
  for (std::size_t c = 0; c < figure.columns.size(); ++c)
    canvas.text({page.left_of(c) + cell_pt / 2, top - head_pt / 2}, in_quotes(figure.columns[c]),
                {.size = label_size, .colour = ink, .bold = true});
  top -= head_pt;
  for (const MatrixGroup& group : figure.groups) {
    if (!group.name.empty()) {
      canvas.text({margin_pt, top - name_pt / 2 - 1}, in_quotes(group.name),
                  {.size = label_size, .colour = grey, .align = drawing::Align::left});
      top -= name_pt;
    }
    for (const MatrixRow& row : group.rows) {
      draw_row(canvas, page, row, group.name.empty() ? 0 : indent_pt, top);
      top -= row_pt;
    }
  }
  for (const std::string& line : below(figure)) {
    canvas.text({margin_pt, top - caption_pt / 2}, in_quotes(line),
                {.size = label_size, .colour = grey, .align = drawing::Align::left});
    top -= caption_pt;
  }
  return canvas;
}

}  // namespace

drawing::Script matrix_script(const MatrixFigure& figure) {
  if (figure.columns.empty() || figure.groups.empty())
    throw InputError("a table of cases needs a result at least; there is none to draw");
  return drawing::Script(
             "set encoding utf8\nunset border\nunset tics\nunset key\nset margins 0,0,0,0\n"
             "set xrange [0:1]\nset yrange [0:1]\n") +
         draw(figure, Layout(figure)).commands() + "plot 1/0\n";
}

void draw_matrix(const std::filesystem::path& path, const MatrixFigure& figure) {
  const drawing::Script script = matrix_script(figure);
  const Layout page(figure);
  drawing::run_gnuplot(drawing::gnuplot_terminal(path, page.width, page.height) + script, path);
}

}  // namespace eerie::figures
