#include "solver/base/utf8.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

using namespace eerie;

namespace {

// A second reader, written by others: the JSON library refuses strings that are no UTF-8.
bool is_utf8(const std::string& text) {
  try {
    [[maybe_unused]] const std::string dumped = nlohmann::json(text).dump();
    return true;
  } catch (const nlohmann::json::type_error&) {
    return false;
  }
}

std::string random_bytes(std::mt19937& random) {
  // First bytes of letters, bytes that go on and borders of what is allowed, more often than not.
  static const std::string likely =
      "a\x80\xbf\xc0\xc2\xdf\xe0\x9f\xa0\xed\xef\xf0\x8f\x90\xf4\xf5\xff";
  std::string text;
  for (auto n = random() % 8; n > 0; --n)
    text +=
        random() % 4 == 0 ? static_cast<char>(random() % 256) : likely[random() % likely.size()];
  return text;
}

TEST(Utf8, TextIsKeptExactlyWhereAnotherReaderTakesIt) {
  std::mt19937 random(7);
  int taken = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const std::string text = random_bytes(random);
    taken += is_utf8(text) ? 1 : 0;
    EXPECT_EQ(valid_utf8(text) == text, is_utf8(text))
        << nlohmann::json::binary({text.begin(), text.end()});
    EXPECT_TRUE(is_utf8(valid_utf8(text)));
  }
  EXPECT_GT(taken, 500);
  EXPECT_LT(taken, 19500);
}

TEST(Utf8, LettersHaveTheirCodes) {
  const std::string text = "aθ€😀";
  std::u32string codes;
  for (std::size_t at = 0; at < text.size(); at += letter_at(text, at).bytes.size())
    codes += letter_at(text, at).code;
  EXPECT_EQ(codes, U"aθ€😀");
}

TEST(Utf8, EveryByteThatIsNoUtf8IsReplacedAlone) {
  EXPECT_EQ(valid_utf8("a\xff"
                       "b"),
            "a\ufffdb");
  EXPECT_EQ(valid_utf8("\xc0\xaf"), "\ufffd\ufffd");            // an overlong '/'
  EXPECT_EQ(valid_utf8("\xed\xa0\x80"), "\ufffd\ufffd\ufffd");  // a surrogate
  EXPECT_EQ(valid_utf8("x\xe2\x82"), "x\ufffd\ufffd");          // cut
}

}  // namespace
