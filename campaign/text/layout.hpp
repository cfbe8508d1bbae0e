#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace eerie::text {

/// The number of terminal columns that a plain text occupies.
std::size_t width_of(std::string_view text);

/// The text, or its beginning with a mark of omission where it is wider than `width`.
std::string cut(std::string_view text, std::size_t width);

/// The text in lines of at most `width` > 0 columns, broken between words where possible.
std::vector<std::string> wrapped(std::string_view text, std::size_t width);

/// Rows of plain text in aligned columns with two spaces in between. The first row is the header.
/// Columns of numbers align right. Where `widths` are given, longer cells wrap.
std::string text_table(const std::vector<std::vector<std::string>>& rows,
                       std::vector<std::size_t> widths = {});

/// The width of each column of the rows.
std::vector<std::size_t> widths_of(const std::vector<std::vector<std::string>>& rows);

/// Whether the cells below the header are numbers, or dashes for "none".
bool is_numeric(const std::vector<std::vector<std::string>>& rows, std::size_t column);

}  // namespace eerie::text
