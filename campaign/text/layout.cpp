#include "campaign/text/layout.hpp"

#include <algorithm>
#include <cctype>
#include <span>

#include "solver/base/utf8.hpp"

namespace eerie::text {
namespace {

struct CodeRange {
  char32_t first, last;
};
/// Letters that take no column of their own, and those that take two (Unicode's East Asian Width).
constexpr CodeRange narrow[] = {{0x300, 0x36f}, {0x200b, 0x200d}, {0xfe00, 0xfe0f}};
constexpr CodeRange wide[] = {{0x1100, 0x115f}, {0x2e80, 0xa4cf},   {0xac00, 0xd7a3},
                              {0xf900, 0xfaff}, {0xfe30, 0xfe6f},   {0xff00, 0xff60},
                              {0xffe0, 0xffe6}, {0x1f300, 0x1faff}, {0x20000, 0x3fffd}};

bool in(std::span<const CodeRange> ranges, char32_t code) {
  return std::ranges::any_of(ranges,
                             [&](const CodeRange& r) { return r.first <= code && code <= r.last; });
}

std::size_t width_of_letter(char32_t code) { return in(narrow, code) ? 0 : in(wide, code) ? 2 : 1; }

/// The bytes at the beginning of `text` that fit into `width`.
std::size_t fitting_bytes(std::string_view text, std::size_t width) {
  std::size_t at = 0, used = 0;
  while (at < text.size()) {
    const Letter letter = letter_at(text, at);
    used += width_of_letter(letter.code);
    if (used > width) break;
    at += letter.bytes.size();
  }
  return at;
}

bool starts_with_digit(const std::string& text, std::size_t at) {
  return text.size() > at && std::isdigit(static_cast<unsigned char>(text[at])) != 0;
}

std::string padded(const std::string& text, std::size_t width, bool right) {
  const std::size_t used = width_of(text);
  const std::string space(width > used ? width - used : 0, ' ');
  return right ? space + text : text + space;
}

}  // namespace

std::size_t width_of(std::string_view text) {
  std::size_t width = 0;
  for (std::size_t at = 0; at < text.size();) {
    const Letter letter = letter_at(text, at);
    width += width_of_letter(letter.code), at += letter.bytes.size();
  }
  return width;
}

std::string cut(std::string_view text, std::size_t width) {
  if (width_of(text) <= width) return std::string(text);
  const std::string_view end = width > 6 ? "..." : "";
  return std::string(text.substr(0, fitting_bytes(text, width - end.size()))) + std::string(end);
}

std::vector<std::string> wrapped(std::string_view text, std::size_t width) {
  std::vector<std::string> lines;
  while (width_of(text) > width) {
    const std::size_t most = std::max<std::size_t>(fitting_bytes(text, width), 1);
    const std::size_t space = text.substr(0, most + 1).rfind(' ');
    const bool between_words = space != std::string_view::npos && space > 0;
    lines.emplace_back(text.substr(0, between_words ? space : most));
    text.remove_prefix(between_words ? space + 1 : most);
  }
  lines.emplace_back(text);
  return lines;
}

bool is_numeric(const std::vector<std::vector<std::string>>& rows, std::size_t column) {
  return rows.size() > 1 && std::all_of(rows.begin() + 1, rows.end(), [&](const auto& row) {
           const std::string& text = row[column];
           return text.empty() || text == "-" || starts_with_digit(text, text[0] == '-' ? 1 : 0);
         });
}

std::vector<std::size_t> widths_of(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows.empty() ? 0 : rows.front().size());
  for (const auto& row : rows)
    for (std::size_t c = 0; c < widths.size(); ++c)
      widths[c] = std::max(widths[c], width_of(row[c]));
  return widths;
}

std::string text_table(const std::vector<std::vector<std::string>>& rows,
                       std::vector<std::size_t> widths) {
  if (widths.empty()) widths = widths_of(rows);
  std::string text;
  for (const auto& row : rows) {
    std::vector<std::vector<std::string>> cells;
    std::size_t height = 1;
    for (std::size_t c = 0; c < row.size(); ++c) {
      cells.push_back(wrapped(row[c], std::max<std::size_t>(widths[c], 1)));
      height = std::max(height, cells.back().size());
    }
    for (std::size_t k = 0; k < height; ++k) {
      std::string line;
      for (std::size_t c = 0; c < row.size(); ++c)
        line +=
            padded(k < cells[c].size() ? cells[c][k] : "", widths[c], is_numeric(rows, c)) + "  ";
      line.erase(line.find_last_not_of(' ') + 1);
      text += line + "\n";
    }
  }
  return text;
}

}  // namespace eerie::text
