#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace eerie::text {

/// Columns of a terminal that a plain text takes.
std::size_t width_of(std::string_view text);

/// The text, or its beginning where it is wider than `width`, with an end that says so.
std::string cut(std::string_view text, std::size_t width);

/// The text in lines of at most `width` > 0, parted between words where it can be.
std::vector<std::string> wrapped(std::string_view text, std::size_t width);

/// Rows of plain text in aligned columns, parted by two spaces; the first row is the header.
/// Columns of numbers align right. Where `widths` are given, longer cells wrap.
std::string text_table(const std::vector<std::vector<std::string>>& rows,
                       std::vector<std::size_t> widths = {});

/// How wide each column of the rows is.
std::vector<std::size_t> widths_of(const std::vector<std::vector<std::string>>& rows);

/// Whether digits, or a dash for "none", stand below the header.
bool is_numeric(const std::vector<std::vector<std::string>>& rows, std::size_t column);

}  // namespace eerie::text
