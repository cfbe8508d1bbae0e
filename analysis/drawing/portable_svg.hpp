#pragma once

#include <string>
#include <string_view>

namespace eerie::drawing {

/// Makes gnuplot's SVG look alike in all renderers. Spaces beside subscripts stay, since some
/// renderers trim each piece of a text. Where DejaVu Sans is missing, letters come from Verdana,
/// which is as wide, or from any font without serifs. gnuplot's own titles, which browsers show as
/// tooltips, go. Only tags change; the words of the figure do not.
std::string portable_svg(std::string_view svg);

}  // namespace eerie::drawing
