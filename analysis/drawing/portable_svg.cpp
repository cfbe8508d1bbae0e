#include "analysis/drawing/portable_svg.hpp"

#include <algorithm>

namespace eerie::drawing {

namespace {

/// gnuplot writes the weight into the family of some groups; their pieces name it once more.
constexpr std::string_view written[] = {"font-family=\"DejaVu Sans\"",
                                        "font-family=\"DejaVu Sans:Bold\""};
constexpr std::string_view families = "font-family=\"DejaVu Sans, Verdana, sans-serif\"";
constexpr std::string_view title = "<title>", end_of_title = "</title>";

std::string portable_tag(std::string_view tag) {
  std::string made(tag);
  if (tag.starts_with("<svg")) made.insert(4, " xml:space=\"preserve\"");
  for (const std::string_view family : written)
    if (const auto at = made.find(family); at != std::string::npos)
      made.replace(at, family.size(), families);
  return made;
}

}  // namespace

std::string portable_svg(std::string_view svg) {
  std::string made;
  made.reserve(svg.size() + svg.size() / 8);
  while (!svg.empty()) {
    const std::size_t open = std::min(svg.find('<'), svg.size());
    made += svg.substr(0, open);
    svg.remove_prefix(open);
    if (svg.starts_with(title)) {
      const std::size_t end = svg.find(end_of_title);
      svg.remove_prefix(end == std::string_view::npos ? svg.size() : end + end_of_title.size());
      continue;
    }
    const std::size_t close = svg.find('>');
    const std::size_t size = close == std::string_view::npos ? svg.size() : close + 1;
    made += portable_tag(svg.substr(0, size));
    svg.remove_prefix(size);
  }
  return made;
}

}  // namespace eerie::drawing
