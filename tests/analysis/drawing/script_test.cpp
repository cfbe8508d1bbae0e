#include "analysis/drawing/script.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

namespace eerie::drawing {
namespace {

// What no text of a user converts to: neither a script, nor a part of one, nor a quoted text
// without in_quotes().
static_assert(!ScriptArgument<std::string> && !ScriptArgument<std::string_view> &&
              !ScriptArgument<const char*> && !ScriptArgument<char[4]> && !ScriptArgument<char>);
static_assert(!std::is_constructible_v<Script, std::string> &&
              !std::is_constructible_v<Script, std::string_view>);
static_assert(!std::is_constructible_v<Quoted, std::string> &&
              !std::is_constructible_v<Quoted, const char*>);
static_assert(!std::is_constructible_v<Literal, std::string>);
static_assert(ScriptArgument<double> && ScriptArgument<Quoted> && ScriptArgument<Literal> &&
              ScriptArgument<Script> && ScriptArgument<Colour>);

TEST(Script, IsMadeOfLiteralsNumbersAndQuotedText) {
  Script text("plot x");
  text += script(" lw {} lc rgb '{}' title {}", 1.5, Colour{255, 0, 16}, in_quotes("a b"));
  EXPECT_EQ((text + "\n").text(), "plot x lw 1.5 lc rgb '#ff0010' title \"a b\"\n");
}

TEST(Script, HoldsPixelsOfTheirSizeOnly) {
  const std::vector<std::uint8_t> rgb(12, 65);
  EXPECT_EQ(Script::pixels(rgb, 2, 2).text(), "AAAAAAAAAAAA");
  EXPECT_THROW(Script::pixels(rgb, 2, 1), std::logic_error);
  EXPECT_THROW(Script::pixels(rgb, 0, 2), std::logic_error);
}

TEST(Quoted, NoByteOfATextIsAQuoteABackquoteABackslashOrAnEndOfLine) {
  for (int first = 0; first < 256; ++first)
    for (int second = 0; second < 256; ++second) {
      const std::string text{static_cast<char>(first), static_cast<char>(second)};
      std::string inside = in_quotes(text).in_script();
      ASSERT_TRUE(inside.size() >= 2 && inside.front() == '"' && inside.back() == '"');
      inside = inside.substr(1, inside.size() - 2);
      for (std::size_t at = inside.find('\\'); at != std::string::npos; at = inside.find('\\', at))
        inside.erase(at, 4);  // \ooo
      for (const char c : inside) {
        EXPECT_EQ(std::string("\"'`@$#").find(c), std::string::npos) << text;
        EXPECT_GE(static_cast<unsigned char>(c), 0x20) << text;
      }
    }
}

TEST(Quoted, MarkupOfTextIsShownAndThatOfTheProgramIsObeyed) {
  const Quoted both = marked_up("v_{{imp}} of {}", in_quotes("a_b"));
  EXPECT_EQ(both.in_script(), "\"v_{imp} of a\\134\\137b\"");
  EXPECT_EQ((in_quotes("a") + marked_up("_{{{}}}", 2)).in_script(), "\"a_{2}\"");
}

TEST(Quoted, CountsTheLettersThatAreSeen) {
  EXPECT_EQ(in_quotes("θ = 45°").letters(), 7u);
  EXPECT_EQ(in_quotes("a_b{c}\\").letters(), 7u);
  EXPECT_EQ(marked_up("v_{{imp}}").letters(), 4u);
  EXPECT_EQ(in_quotes("a\nb").letters(), 4u);  // as "a\\nb"
  EXPECT_EQ(in_quotes(std::string(5000, 'x')).letters(), Quoted::most_letters + 1);
  EXPECT_TRUE(in_quotes("").empty());
}

}  // namespace
}  // namespace eerie::drawing
