#include "analysis/drawing/script.hpp"

#include <algorithm>
#include <stdexcept>

#include "analysis/drawing/letter_widths.hpp"
#include "solver/base/utf8.hpp"

namespace eerie::drawing {

namespace {

constexpr std::string_view markup = "{}_^@&~\\";
/// A backslash, and an empty group behind it: terminals look for "\U+0041" before they look for
/// markup, and take text without any other markup as it is, its backslashes doubled.
constexpr std::string_view backslash = "\\\\{}";

constexpr std::string_view no_width = "\u200b";

/// A letter as it is shown, with a backslash before markup.
std::string shown(const Letter& letter) {
  if (!letter.valid) return "\xef\xbf\xbd";
  const auto code = static_cast<unsigned>(letter.code);
  if (is_control(letter.code))
    return fmt::format("{}{}", backslash,
                       code == '\n'   ? "n"
                       : code == '\t' ? "t"
                       : code < 0x100 ? fmt::format("x{:02x}", code)
                                      : fmt::format("u{:04x}", code));
  if (letter.code == '\\') return std::string(backslash);
  std::string text(letter.bytes);
  if (markup.find(text) != std::string_view::npos) text.insert(0, 1, '\\');
  return text;
}

bool is_first_byte(char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }

}  // namespace

Quoted in_quotes(std::string_view text) {
  std::string enhanced;
  std::size_t letters = 0;
  for (std::size_t at = 0; at < text.size(); ++letters) {
    if (letters == Quoted::most_letters) {
      enhanced += "…";
      break;
    }
    const Letter letter = letter_at(text, at);
    // XML has no "]]>" in text, and gnuplot writes it all the same.
    if (enhanced.ends_with("]]") && letter.code == '>') enhanced += no_width;
    enhanced += shown(letter);
    at += letter.bytes.size();
  }
  return Quoted::with_letters(std::move(enhanced));
}

Quoted operator+(const Quoted& a, const Quoted& b) {
  return Quoted::with_letters(a.enhanced_ + b.enhanced_);
}

Quoted Quoted::with_letters(std::string enhanced) {
  Quoted made;
  bool escaped = false;
  for (const char c : enhanced) {
    const bool is_markup = !escaped && markup.find(c) != std::string_view::npos;
    escaped = !escaped && c == '\\';
    if (is_first_byte(c) && !is_markup) ++made.letters_;
  }
  made.enhanced_ = std::move(enhanced);
  return made;
}

double Quoted::width(bool bold) const { return width_in_em(enhanced_, bold); }

std::string Quoted::in_script() const {
  std::string out = "\"";
  bool escaped = false, octal = false;
  for (const char c : enhanced_) {
    const bool obeyed = std::string_view("\\\"'`$#@").find(c) != std::string_view::npos;
    // gnuplot reads more than three digits.
    const bool goes_on = octal && c >= '0' && c <= '9';
    octal = obeyed || escaped || goes_on;
    out += octal ? fmt::format("\\{:03o}", static_cast<unsigned char>(c)) : std::string(1, c);
    escaped = !escaped && c == '\\';
  }
  return out + "\"";
}

Script Script::pixels(std::span<const std::uint8_t> rgb, int width, int height) {
  if (width < 1 || height < 1 ||
      rgb.size() != 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
    throw std::logic_error("pixels of another size than they say");
  Script made;
  made.text_.assign(rgb.begin(), rgb.end());
  return made;
}

}  // namespace eerie::drawing
