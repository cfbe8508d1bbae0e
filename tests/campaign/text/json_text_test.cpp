#include "campaign/text/json_text.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace eerie::text {
namespace {
using nlohmann::json;

TEST(JsonText, OfUtf8IsWhatTheLibraryWrites) {
  const json document = {{"path", "\u00fcber/\\x.sqlite"}, {"list", {1, 2.5, nullptr}}};
  EXPECT_EQ(json_text(document), document.dump());
  EXPECT_EQ(json_text(document, 1), document.dump(1));
}

TEST(JsonText, EscapesBytesThatAreNoUtf8WhereverTheyStand) {
  const json document = {{"a\xff", {"b\xfe\xc3", {{"c", "d\xc3\xa9\x80"}}}}, {"n", 1}};
  const json read = json::parse(json_text(document, 1));
  EXPECT_EQ(read, (json{{"a\\xff", {"b\\xfe\\xc3", {{"c", "d\xc3\xa9\\x80"}}}}, {"n", 1}}));
}

}  // namespace
}  // namespace eerie::text
