#include "solver/base/text/shell_word.hpp"

#include <algorithm>
#include <cctype>

#include "solver/base/utf8.hpp"

namespace eerie {
namespace {

bool is_plain(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
         std::string("_-./:=,+@%").find(letter) != std::string::npos;
}

/// Whether a terminal would not show all of it, or not as it is.
bool is_hidden(const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const Letter letter = letter_at(text, at);
    if (!letter.valid || is_control(letter.code)) return true;
    at += letter.bytes.size();
  }
  return false;
}

/// Letters that every terminal shows, from which a shell makes the text.
std::string printed_by_shell(const std::string& text) {
  std::string word = "\"$(printf '";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '%')
      word += "%%";
    else if (byte < 0x20 || byte > 0x7e || c == '\\' || c == '\'')
      for (const int part : {-1, 6, 3, 0})
        word += part < 0 ? '\\' : static_cast<char>('0' + ((byte >> part) & 7));
    else
      word += c;
  }
  return word + "')\"";
}

}  // namespace

std::string shell_word(const std::string& text) {
  if (!text.empty() && std::ranges::all_of(text, is_plain)) return text;
  if (is_hidden(text)) return printed_by_shell(text);
  std::string word = "'";
  for (const char c : text) {
    if (c == '\'')
      word += "'\\''";
    else
      word += c;
  }
  return word + "'";
}

}  // namespace eerie
