#pragma once

#include <string_view>

namespace eerie::drawing {

/// The width of words in gnuplot's enhanced text, set in DejaVu Sans, in units of the type size.
/// Braces, and a backslash before markup, have no width. Subscripts and superscripts are 0.8 as
/// large. Letters beyond ASCII count as wide as a Greek one.
double width_in_em(std::string_view enhanced, bool bold);

}  // namespace eerie::drawing
