#include "analysis/pictures/panels_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/drawing/canvas.hpp"
#include "analysis/drawing/gnuplot.hpp"
#include "analysis/drawing/grouped.hpp"
#include "solver/base/error.hpp"

namespace eerie::pictures {

namespace {

using drawing::Literal, drawing::Script, drawing::script, drawing::in_quotes, drawing::marked_up;

// All in points.
constexpr double column_width = 255, page_width = 510;
constexpr std::size_t most_in_column = 3, most_in_row = 5;
constexpr double border = 3, gap = 3, stamp_height = 11, strip_height = 30, title_height = 13;
constexpr double longest_scale_bar = 90;
constexpr int pixels_per_point = 5;
constexpr drawing::Colour ink{0x22, 0x22, 0x22}, frame_grey{0x99, 0x99, 0x99};

/// Where things are on the page.
struct Page {
  double width, height, panel;
  std::size_t columns;
  double head;  ///< height of the title

  explicit Page(std::size_t panels, bool titled = false)
      : width(page_width), height(0), panel(0), columns(panels), head(titled ? title_height : 0) {
    if (panels <= most_in_column) width = column_width;
    const std::size_t rows = (panels + most_in_row - 1) / most_in_row;
    columns = (panels + rows - 1) / rows;
    const auto n = static_cast<double>(columns);
    panel = std::floor((width - 2 * border - (n - 1) * gap) / n);
    height = static_cast<double>(rows) * (panel + stamp_height) + strip_height + head;
  }

  drawing::Area area(std::size_t k) const {
    const std::size_t rows_above = k / columns;
    const auto column = static_cast<double>(k % columns), row = static_cast<double>(rows_above);
    const double top = height - head - stamp_height - row * (panel + stamp_height);
    const double left = border + column * (panel + gap);
    return {{left, top - panel}, {left + panel, top}};
  }
};

/// 1, 2 or 5 times a power of ten, at most `length`.
double round_length(double length) {
  const double decade = std::pow(10, std::floor(std::log10(length)));
  return (length >= 5 * decade ? 5 : length >= 2 * decade ? 2 : 1) * decade;
}

void draw_scale_bar(drawing::Canvas& canvas, const Page& page, double frame_width) {
  const double longest = std::min(0.45 * page.panel, longest_scale_bar);
  const double length = round_length(longest / page.panel * frame_width);
  const double width = page.panel * length / frame_width, y = 14;
  canvas.line({border, y}, {border + width, y}, ink, 1.6);
  canvas.text({border + width / 2, y - 7},
              length < 2000 ? marked_up("{:g} m", length) : marked_up("{:g} km", length / 1000),
              {.size = 6.5, .colour = ink});
}

void draw_swatch(drawing::Canvas& canvas, double x, drawing::Colour colour, Literal words) {
  canvas.fill({{x, 10}, {x + 7, 17}}, colour);
  canvas.text({x + 10, 13.5}, marked_up("{}", words),
              {.size = 6.5, .colour = ink, .align = drawing::Align::left});
}

constexpr double bar_width = 110, bar_height = 6, bar_bottom = 12;
double bar_left(const Page& page) { return page.width - border - 14 - bar_width; }

/// In m, or in cm/s.
std::string in_unit(const ColourScale& scale, double value) {
  return fmt::format("{:g}", scale.colour == ParticleColour::speed ? 100 * value : value);
}

void draw_colour_bar(drawing::Canvas& canvas, const Page& page, const ColourScale& scale) {
  const double left = bar_left(page);
  canvas.outline({{left, bar_bottom}, {left + bar_width, bar_bottom + bar_height}}, ink, 0.4);
  for (const double part : {0.0, 0.5, 1.0})
    canvas.text({left + part * bar_width, bar_bottom - 6},
                in_quotes((part == 1 && scale.highest > scale.top ? "≥ " : "") +
                          in_unit(scale, part * scale.top)),
                {.size = 6, .colour = ink});
  canvas.text({left + bar_width / 2, bar_bottom + bar_height + 5},
              in_quotes(scale.colour == ParticleColour::speed ? "speed in own clump (cm/s)"
                                                              : "initial depth (m)"),
              {.size = 6.5, .colour = ink});
}

void draw_title(drawing::Canvas& canvas, const Page& page, const drawing::Quoted& title) {
  canvas.text({border + 1, page.height - title_height / 2}, title,
              {.size = drawing::size_that_fits(title, page.width - 2 * border - 2, 7.5),
               .colour = ink,
               .align = drawing::Align::left});
}

/// "5,000 s, contact", or the time alone where both have no room.
drawing::Quoted stamp_of(const Panel& panel, double width) {
  const drawing::Quoted time = in_quotes(drawing::grouped(std::llround(panel.time)) + " s");
  if (panel.name.empty()) return time;
  const drawing::Quoted both = time + in_quotes(", " + panel.name);
  return drawing::text_width(both, 7) <= width ? both : time;
}

void draw_words(drawing::Canvas& canvas, const Page& page, const PanelsFigure& figure) {
  for (std::size_t k = 0; k < figure.panels.size(); ++k) {
    const drawing::Area area = page.area(k);
    const Panel& panel = figure.panels[k];
    // Images lie before lines: the frame is drawn round them.
    canvas.outline({{area.low.x - 0.5, area.low.y - 0.5}, {area.high.x + 0.5, area.high.y + 0.5}},
                   frame_grey, 0.5);
    canvas.text({area.low.x + 1, area.high.y + 4.5}, stamp_of(panel, area.width() - 2),
                {.size = 7, .colour = ink, .align = drawing::Align::left});
    if (panel.outside == 0) continue;
    const drawing::Quoted outside = marked_up("{} remnant{} outside", panel.outside,
                                              panel.outside > 1 ? Literal("s") : Literal(""));
    const drawing::Point at{area.low.x + 3, area.low.y + 5};
    // Particles may lie there.
    canvas.patch({{at.x - 1, at.y - 4}, {at.x + drawing::text_width(outside, 6) + 1, at.y + 4}},
                 {255, 255, 255});
    canvas.text(at, outside, {.size = 6, .colour = ink, .align = drawing::Align::left});
  }
  if (!figure.title.empty()) draw_title(canvas, page, figure.title);
  draw_scale_bar(canvas, page, figure.frame_width);
  if (figure.scale.colour == ParticleColour::body) {
    draw_swatch(canvas, page.width - border - 90, target_colour, "target");
    draw_swatch(canvas, page.width - border - 48, impactor_colour, "impactor");
  } else {
    draw_colour_bar(canvas, page, figure.scale);
  }
}

/// Images and where they lie; gnuplot reads their bytes behind the command that draws them.
struct Images {
  Script command, bytes;

  void add(const Bitmap& image, const drawing::Area& area) {
    const double dx = area.width() / image.width, dy = area.height() / image.height;
    command += script(
        "{} '-' binary array=({},{}) format='%uchar' dx={} dy={} origin=({},{}) flipy using 1:2:3 "
        "with rgbimage notitle",
        command.empty() ? Literal("plot") : Literal(","), image.width, image.height, dx, dy,
        area.low.x + dx / 2, area.low.y + dy / 2);
    bytes += Script::pixels(image.rgb, image.width, image.height);
  }
};

}  // namespace

int panel_pixels(std::size_t panels) {
  return pixels_per_point * static_cast<int>(Page(panels).panel);
}

drawing::Script panels_script(const PanelsFigure& figure) {
  const Page page(figure.panels.size(), !figure.title.empty());
  drawing::Canvas canvas(page.width, page.height);
  draw_words(canvas, page, figure);
  Images images;
  for (std::size_t k = 0; k < figure.panels.size(); ++k)
    images.add(figure.panels[k].image, page.area(k));
  if (figure.scale.colour != ParticleColour::body) {
    const double left = bar_left(page);
    images.add(scale_image(static_cast<int>(2 * bar_width), 2),
               {{left, bar_bottom}, {left + bar_width, bar_bottom + bar_height}});
  }
  return script(
             "set encoding utf8\nunset key\nunset border\nunset tics\n"
             "set lmargin at screen 0\nset rmargin at screen 1\nset tmargin at screen 1\n"
             "set bmargin at screen 0\nset xrange [0:{}]\nset yrange [0:{}]\n",
             page.width, page.height) +
         canvas.commands() + images.command + "\n" + images.bytes;
}

void draw_panels(const std::filesystem::path& path, const PanelsFigure& figure) {
  if (figure.panels.empty()) throw InputError(path.string() + ": there is nothing to draw");
  const Page page(figure.panels.size(), !figure.title.empty());
  drawing::run_gnuplot(
      drawing::gnuplot_terminal(path, page.width, page.height) + panels_script(figure), path);
}

}  // namespace eerie::pictures
