#include "tests/campaign/sweeps/malformed_sweeps.hpp"

#include <gmock/gmock.h>

#include <set>

#include "campaign/sweeps/sweep.hpp"
#include "campaign/text/json_file.hpp"
#include "solver/base/error.hpp"

namespace eerie::sweeps {
namespace {

using test::MalformedSweep;

class EveryMalformedSweep : public testing::TestWithParam<MalformedSweep> {};

TEST_P(EveryMalformedSweep, IsRefusedNamingFileAndFault) {
  try {
    const Sweep sweep = parse_sweep(text::parse_json(GetParam().text, "bad.json"), {}, "bad.json");
    const std::size_t jobs = expand(sweep).size();
    FAIL() << "was taken, and makes " << jobs << " jobs";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("bad.json"));
    EXPECT_THAT(error.what(), testing::HasSubstr(GetParam().expected));
  }
}

INSTANTIATE_TEST_SUITE_P(Sweep, EveryMalformedSweep, testing::ValuesIn(test::malformed_sweeps()),
                         [](const auto& tested) { return tested.param.name; });

TEST(MalformedSweeps, AreAtLeastAHundredDifferentFiles) {
  std::set<std::string> texts;
  for (const MalformedSweep& sweep : test::malformed_sweeps()) texts.insert(sweep.text);
  EXPECT_GE(texts.size(), 100u);
  EXPECT_EQ(texts.size(), test::malformed_sweeps().size());
}

TEST(MalformedSweeps, TheirSurroundingsAreSound) {
  for (const std::string& text :
       {test::with_scene("{}"), test::with_grid(R"({"q": [1]})"), test::with_v("[20]"),
        test::with_name("\"s\""), test::with_points(R"([{"q": 1}])")})
    EXPECT_EQ(expand(parse_sweep(text::parse_json(text, "good.json"), {}, "good.json")).size(), 1u)
        << text;
}

}  // namespace
}  // namespace eerie::sweeps
