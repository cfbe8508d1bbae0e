#include "campaign/text/json_file.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>

#include "solver/base/error.hpp"

namespace eerie::text {
namespace {
using nlohmann::json;

template <class T>
T whole(const char* text) {
  T number{};
  read_whole(json::parse(text), number);
  return number;
}

TEST(ParseJson, RefusesANulByteWhereverItIs) {
  using namespace std::string_view_literals;
  for (const std::string_view text : {"{}\0"sv, "{}\0{\"a\": 1}"sv, "\0{}"sv})
    EXPECT_THROW(parse_json(text, "a.json"), InputError);
}

TEST(WholeNumber, IsReadAsItStandsWhateverItsSpelling) {
  EXPECT_EQ(whole<int>("12"), 12);
  EXPECT_EQ(whole<int>("-12"), -12);
  EXPECT_EQ(whole<int>("12.0"), 12);
  EXPECT_EQ(whole<std::int64_t>("4e3"), 4000);
  EXPECT_EQ(whole<std::int64_t>("9223372036854775807"), std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(whole<std::size_t>("18446744073709551615"), std::numeric_limits<std::size_t>::max());
}

TEST(WholeNumber, IsRefusedWhereItIsNoneOrDoesNotFit) {
  for (const char* text : {"1.5", "6e48", "-6e48", "2147483648", "-2147483649", "null", "true",
                           "\"1\"", "[1]", "18446744073709551615"})
    EXPECT_THROW(whole<int>(text), json::exception) << text;
  for (const char* text : {"9223372036854775808", "1e19", "9007199254740994.0"})
    EXPECT_THROW(whole<std::int64_t>(text), json::exception) << text;
  EXPECT_THROW(whole<std::size_t>("-1"), json::exception);
}

}  // namespace
}  // namespace eerie::text
