#include "campaign/slurm/profile.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "campaign/text/json_file.hpp"
#include "solver/base/error.hpp"

namespace eerie::slurm {
namespace {
using namespace std::chrono_literals;
using testing::HasSubstr;

SlurmProfile parsed(const std::string& text) {
  return parse_slurm_profile(text::parse_json(text, "p.json"), "p.json");
}

TEST(SlurmProfile, OfNothingLeavesTheChoiceToTheCluster) {
  const SlurmProfile p = parsed("{}");
  EXPECT_EQ(p.partition, "");
  EXPECT_EQ(p.time_limit, std::nullopt);
  EXPECT_EQ(p.max_array_size, std::nullopt);
  // Defaults stand in the schema and in the struct.
  const SlurmProfile made;
  EXPECT_EQ(p.cpus_per_task, made.cpus_per_task);
  EXPECT_EQ(p.max_queued, made.max_queued);
  EXPECT_EQ(p.minutes_per_array_task, made.minutes_per_array_task);
  EXPECT_EQ(p.signal_before_end_s, made.signal_before_end_s);
  EXPECT_EQ(p.poll_interval_s, made.poll_interval_s);
}

TEST(SlurmProfile, TakesEveryField) {
  const SlurmProfile p = parsed(R"({"partition": "batch,long", "account": "ab12", "qos": "normal",
    "constraint": "[rack1|rack2]&avx512", "time": "1-12", "cpus_per_task": 8, "memory": "2G",
    "extra_sbatch_options": ["--exclude=n17", "-xn18", "--mem-per-cpu=1G", "--exclusive"],
    "max_array_size": 5001, "max_queued": 4000, "minutes_per_array_task": 45.5,
    "signal_before_end_s": 300, "poll_interval_s": 30})");
  EXPECT_EQ(p.partition, "batch,long");
  EXPECT_EQ(p.constraint, "[rack1|rack2]&avx512");
  EXPECT_EQ(p.time_limit, 36h);
  EXPECT_EQ(p.extra_sbatch_options.size(), 4u);
  EXPECT_EQ(p.max_array_size, 5001);
  EXPECT_EQ(p.minutes_per_array_task, 45.5);
}

TEST(TimeLimit, IsReadAsSbatchReadsIt) {
  EXPECT_EQ(parse_time_limit("90"), 90min);
  EXPECT_EQ(parse_time_limit("90:30"), 90min + 30s);
  EXPECT_EQ(parse_time_limit("02:00:00"), 2h);
  EXPECT_EQ(parse_time_limit("2-12"), 60h);
  EXPECT_EQ(parse_time_limit("2-12:30"), 60h + 30min);
  EXPECT_EQ(parse_time_limit("2-12:30:15"), 60h + 30min + 15s);
  for (const char* text : {"", "0", "-5", "1:2:3:4", "two", "1h", "1-", "5 ", "99999999999999"})
    EXPECT_EQ(parse_time_limit(text), std::nullopt) << text;
}

struct BadProfile {
  const char* name;
  const char* text;
  std::vector<const char*> expected;  ///< words of the complaint
};

class EveryBadProfile : public testing::TestWithParam<BadProfile> {};

TEST_P(EveryBadProfile, IsRefusedNamingFieldValueAndMend) {
  try {
    parsed(GetParam().text);
    FAIL() << "was taken";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("p.json"));
    EXPECT_THAT(error.what(), testing::Not(HasSubstr("\n")));
    for (const char* words : GetParam().expected) EXPECT_THAT(error.what(), HasSubstr(words));
  }
}

const std::vector<BadProfile> bad_profiles = {
    {"UnknownField", R"({"partitions": "x"})", {"profile.partitions", "use one of", "partition"}},
    {"NotAnObject", "[]", {"must be an object"}},
    {"Number", R"({"partition": 3})", {"profile.partition = 3", "a string"}},
    {"NoCores", R"({"cpus_per_task": 0})", {"cpus_per_task = 0", "at least 1", "4096"}},
    {"PartOfACore", R"({"cpus_per_task": 1.5})", {"cpus_per_task = 1.5", "integer"}},
    {"HurriedPoll", R"({"poll_interval_s": 0})", {"poll_interval_s = 0", "at least 1"}},
    {"NoRoom", R"({"max_queued": 0})", {"max_queued = 0", "at least 1"}},
    {"EmptyAccount", R"({"account": ""})", {"profile.account", "remove the field"}},
    {"LineBreak", R"({"partition": "a\n#SBATCH --uid=0"})", {"profile.partition", "one line"}},
    {"Nul", R"({"qos": "a\u0000b"})", {"profile.qos", "control characters"}},
    {"Memory", R"({"memory": "2 GB"})", {"profile.memory", "2 GB", "\"2G\""}},
    {"Time", R"({"time": "two hours"})", {"profile.time", "two hours", "02:00:00"}},
    {"ShortTime", R"({"time": "2"})", {"profile.time", "at least 180 s", "raise it"}},
    {"OptionList", R"({"extra_sbatch_options": "--x"})", {"must be an array"}},
    {"OptionNumber", R"({"extra_sbatch_options": [1]})", {"extra_sbatch_options[0] = 1"}},
    {"OptionWord", R"({"extra_sbatch_options": ["-x", "n1"]})", {"[1] = \"n1\"", "one word"}},
    {"OptionEnd", R"({"extra_sbatch_options": ["--"]})", {"[0] = \"--\"", "one word"}},
    {"OptionBreak", R"({"extra_sbatch_options": ["--a=b\nc"]})", {"[0]", "one line"}},
    {"OptionArray", R"({"extra_sbatch_options": ["--array=0-5"]})", {"--array=0-5", "itself"}},
    {"OptionShort", R"({"extra_sbatch_options": ["-Jmine"]})", {"-Jmine", "itself"}},
    {"OptionBeginning", R"({"extra_sbatch_options": ["--no-req"]})", {"--no-req", "itself"}},
    {"OptionOfAField", R"({"extra_sbatch_options": ["--time=1"]})", {"--time=1", "itself"}},
    {"TwiceTheSame", R"({"qos": "a", "qos": "b"})", {"twice"}},
};

INSTANTIATE_TEST_SUITE_P(SlurmProfile, EveryBadProfile, testing::ValuesIn(bad_profiles),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace eerie::slurm
