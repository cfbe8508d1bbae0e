#include <gtest/gtest.h>

#include "tests/campaign/job_folder/job_files.hpp"

namespace eerie::job_folder {
namespace {
using nlohmann::json;

/// The text of a sound result, and whether spoilt ones pass for another result.
class ResultText : public testing::Test {
 protected:
  /// Refused, or the same document by other words (a space for a line break, E for e).
  bool is_refused_or_the_same(const std::string& spoilt) {
    if (!parse_result(spoilt, hash_)) return true;
    return json::parse(spoilt, nullptr, false) == document_;
  }

  Scene scene_ = parse_scene(json::object());
  std::string hash_ = scene_hash(scene_);
  json document_ = result_json(scene_, test::sample_summary(scene_), test::sample_analysis());
  std::string text_ = document_.dump(1) + "\n";  // as workers write it
};

TEST_F(ResultText, UnspoiltIsAResult) { EXPECT_TRUE(parse_result(text_, hash_)); }

TEST_F(ResultText, WithAnyBitFlippedIsNoOtherResult) {
  std::size_t accepted = 0;
  for (std::size_t bit = 0; bit < 8 * text_.size(); ++bit) {
    std::string spoilt = text_;
    spoilt[bit / 8] = static_cast<char>(spoilt[bit / 8] ^ (1 << (bit % 8)));
    ASSERT_TRUE(is_refused_or_the_same(spoilt)) << "bit " << bit;
    accepted += parse_result(spoilt, hash_).has_value();
  }
  EXPECT_LT(accepted, text_.size());  // white space: a bit or two of eight
}

TEST_F(ResultText, CutOffAnywhereIsNoResult) {
  for (std::size_t length = 0; length + 1 < text_.size(); ++length)
    ASSERT_FALSE(parse_result(text_.substr(0, length), hash_)) << length;
  EXPECT_TRUE(parse_result(text_.substr(0, text_.size() - 1), hash_));  // the last line break
}

TEST_F(ResultText, WithAnyValueChangedIsNoResult) {
  const json flat = document_.flatten();
  for (const auto& [path, value] : flat.items()) {
    json changed = document_;
    changed[json::json_pointer(path)] = value.is_number() ? json(value.get<double>() + 1) : "x";
    EXPECT_FALSE(parse_result(changed.dump(), hash_)) << path;
  }
}

TEST_F(ResultText, OfTheFirstVersionIsReadWithoutAChecksum) {
  json first = document_;
  first["version"] = 1;
  EXPECT_FALSE(parse_result(first.dump(), hash_));  // one that has a checksum is of no such version
  first.erase("sha256");
  first["provenance"].erase("solver_version");
  first["provenance"]["version"] = "0.1.0";  // there were no others
  const auto stored = parse_result(first.dump(), hash_);
  ASSERT_TRUE(stored);
  EXPECT_EQ(stored->result.solver_version, first["provenance"]["version"]);
}

TEST_F(ResultText, NestedWithoutEndIsNoResult) {
  EXPECT_FALSE(parse_result(std::string(1000000, '['), hash_));
  EXPECT_FALSE(parse_result(std::string(1000000, '{'), hash_));
}

}  // namespace
}  // namespace eerie::job_folder
