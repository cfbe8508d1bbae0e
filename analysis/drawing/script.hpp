#pragma once

#include <fmt/format.h>

#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "analysis/drawing/palette.hpp"

namespace eerie::drawing {

/// Words from the source of this program. No text of a user can become one.
struct Literal {
  std::string_view text;
  consteval Literal(const char* words) : text(words) {}
};

class Script;
class Quoted;

/// The types that may enter a script or a marked up text: numbers, and types to which no raw text
/// converts. All other types do not compile.
template <class T>
struct ScriptWord {};
template <class T>
requires(std::is_arithmetic_v<T> && !std::same_as<T, char>) struct ScriptWord<T> {
  using type = T;
  static T of(T value) { return value; }
};
template <>
struct ScriptWord<Colour> {
  using type = std::string;
  static std::string of(Colour colour) { return hex(colour); }
};
template <>
struct ScriptWord<Literal> {
  using type = std::string_view;
  static std::string_view of(Literal words) { return words.text; }
};
template <>
struct ScriptWord<Quoted> {
  using type = std::string;
  static std::string of(const Quoted& text);  ///< with quotation marks
};
template <>
struct ScriptWord<Script> {
  using type = std::string_view;
  static std::string_view of(const Script& script);
};
template <class T>
concept ScriptArgument = requires {
  typename ScriptWord<T>::type;
};

/// A format string of fmt that is a literal. The compiler checks that it fits its arguments.
template <class... Words>
struct LiteralFormat {
  fmt::string_view text;
  consteval LiteralFormat(const char* format) : text(format) {
    [[maybe_unused]] const fmt::format_string<Words...> fits(format);
  }
};

/// A text in a figure, shown letter by letter. In a script nothing in it can end its string, be a
/// command, or be markup (_ ^ @ { } ~ &). Control characters appear as escapes ("\n") and bytes
/// that are not UTF-8 as U+FFFD. Beyond most_letters the text is cut and ends in "…". in_quotes()
/// makes it; marked_up() makes it from the program's own words with markup.
class Quoted {
 public:
  static constexpr std::size_t most_letters = 200;

  Quoted() = default;
  bool empty() const { return enhanced_.empty(); }
  std::size_t letters() const { return letters_; }  ///< the number of visible letters
  /// The width in DejaVu Sans, in units of the type size.
  double width(bool bold = false) const;
  /// The text for gnuplot: in quotation marks, with escapes for everything that gnuplot might obey.
  std::string in_script() const;

  friend Quoted in_quotes(std::string_view text);
  friend Quoted operator+(const Quoted& a, const Quoted& b);
  template <ScriptArgument... A>
  friend Quoted marked_up(LiteralFormat<typename ScriptWord<A>::type...> format,
                          const A&... values);

 private:
  static const std::string& markup_of(const Quoted& text) { return text.enhanced_; }
  template <class T>
  static auto markup_of(const T& value) {
    return ScriptWord<T>::of(value);
  }
  template <class... Markup>
  static Quoted of_markup(fmt::string_view format, const Markup&... values) {
    return with_letters(fmt::vformat(format, fmt::make_format_args(values...)));
  }
  static Quoted with_letters(std::string enhanced);

  std::string enhanced_;  ///< gnuplot's enhanced text, with a backslash before characters of markup
  std::size_t letters_ = 0;
};

Quoted in_quotes(std::string_view text);
Quoted operator+(const Quoted& a, const Quoted& b);

/// Makes a text from the program's own words with gnuplot's markup ("v_{{imp}} = {:g}"), around
/// numbers and texts that are shown letter by letter.
template <ScriptArgument... A>
Quoted marked_up(LiteralFormat<typename ScriptWord<A>::type...> format, const A&... values) {
  return Quoted::of_markup(format.text, Quoted::markup_of(values)...);
}

/// Commands for gnuplot. They consist of literals, numbers and quoted text alone; raw text of a
/// user does not compile into a script.
class Script {
 public:
  Script() = default;
  Script(Literal words) : text_(words.text) {}
  const std::string& text() const { return text_; }
  bool empty() const { return text_.empty(); }

  Script& operator+=(const Script& more) {
    text_ += more.text_;
    return *this;
  }
  Script& operator+=(Literal more) {
    text_ += more.text;
    return *this;
  }
  friend Script operator+(Script a, const Script& b) { return a += b; }
  friend Script operator+(Script a, Literal b) { return a += b; }
  friend Script operator+(Literal a, const Script& b) { return Script(a) += b; }

  /// Adds the colours of `width` by `height` pixels, which a plot of '-' with a binary array of
  /// that size reads. Throws std::logic_error where their number differs.
  static Script pixels(std::span<const std::uint8_t> rgb, int width, int height);

  template <ScriptArgument... A>
  friend Script script(LiteralFormat<typename ScriptWord<A>::type...> format, const A&... values);

 private:
  template <class... Words>
  static Script of_words(fmt::string_view format, const Words&... words) {
    Script made;
    made.text_ = fmt::vformat(format, fmt::make_format_args(words...));
    return made;
  }
  std::string text_;
};

/// Makes a script, for example script("set label {} at {},{}\n", in_quotes(title), x, y).
template <ScriptArgument... A>
Script script(LiteralFormat<typename ScriptWord<A>::type...> format, const A&... values) {
  return Script::of_words(format.text, ScriptWord<A>::of(values)...);
}

inline std::string ScriptWord<Quoted>::of(const Quoted& text) { return text.in_script(); }
inline std::string_view ScriptWord<Script>::of(const Script& script) { return script.text(); }

}  // namespace eerie::drawing
