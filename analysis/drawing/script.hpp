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

/// Words that stand in this program's source: no text of a user can be one.
struct Literal {
  std::string_view text;
  consteval Literal(const char* words) : text(words) {}
};

class Script;
class Quoted;

/// What may stand in a script or in a marked up text: numbers, and types that no raw text converts
/// to. Others are no ScriptArgument, and do not compile.
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
  static std::string of(const Quoted& text);  ///< with its quotation marks
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

/// A format of fmt's that is a literal and fits its arguments, which the compiler sees to.
template <class... Words>
struct LiteralFormat {
  fmt::string_view text;
  consteval LiteralFormat(const char* format) : text(format) {
    [[maybe_unused]] const fmt::format_string<Words...> fits(format);
  }
};

/// Text of a figure. It is shown letter by letter: in a script nothing in it can end its string, be
/// a command, or be markup (_ ^ @ { } ~ &). Controls are shown as escapes ("\n"), what is no UTF-8
/// as U+FFFD, and of more than most_letters those, and "…". in_quotes() makes it, and marked_up()
/// where the program's own words have markup.
class Quoted {
 public:
  static constexpr std::size_t most_letters = 200;

  Quoted() = default;
  bool empty() const { return enhanced_.empty(); }
  std::size_t letters() const { return letters_; }  ///< that are seen
  /// As gnuplot reads it: with quotation marks, and with escapes for all that it might obey.
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

  std::string enhanced_;  ///< gnuplot's enhanced text: a backslash before what would be markup
  std::size_t letters_ = 0;
};

Quoted in_quotes(std::string_view text);
Quoted operator+(const Quoted& a, const Quoted& b);

/// Words of the program's own with gnuplot's markup ("v_{{imp}} = {:g}"), around numbers and texts
/// that stay as they are.
template <ScriptArgument... A>
Quoted marked_up(LiteralFormat<typename ScriptWord<A>::type...> format, const A&... values) {
  return Quoted::of_markup(format.text, Quoted::markup_of(values)...);
}

/// Commands for gnuplot. Made of literals, numbers and quoted text alone: text of a user does not
/// compile into one.
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

  /// The colours of `width` by `height` pixels, as a plot of '-' with a binary array of that size
  /// reads them. Throws std::logic_error where they are more or less.
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

/// script("set label {} at {},{}\n", in_quotes(title), x, y).
template <ScriptArgument... A>
Script script(LiteralFormat<typename ScriptWord<A>::type...> format, const A&... values) {
  return Script::of_words(format.text, ScriptWord<A>::of(values)...);
}

inline std::string ScriptWord<Quoted>::of(const Quoted& text) { return text.in_script(); }
inline std::string_view ScriptWord<Script>::of(const Script& script) { return script.text(); }

}  // namespace eerie::drawing
