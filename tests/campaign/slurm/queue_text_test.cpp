#include "campaign/slurm/queue_text.hpp"

#include <gmock/gmock.h>

namespace eerie::slurm {
namespace {
using testing::IsEmpty;
using testing::Pair;
using testing::UnorderedElementsAre;

TEST(SbatchAnswer, GivesTheIdWithAndWithoutACluster) {
  EXPECT_EQ(submitted_id("1234\n"), (SlurmJobId{1234, ""}));
  EXPECT_EQ(submitted_id("1234;alps\n"), (SlurmJobId{1234, "alps"}));
  EXPECT_EQ(submitted_id("Welcome to alps!\n1234\n"), (SlurmJobId{1234, ""}));
  EXPECT_EQ(submitted_id(" 9000000000 \n"), (SlurmJobId{9000000000, ""}));
}

TEST(SbatchAnswer, GivesNoneWhereThereIsNone) {
  for (const char* text : {"", "\n", "Submitted batch job 12", "12x", "-12", ";alps", "12_3"})
    EXPECT_EQ(submitted_id(text), std::nullopt) << text;
}

TEST(SqueueAnswer, ListsArrayTasksOneByOne) {
  const Queue queue = parse_queue("17_4|RUNNING|eerie-a\n17_5|PENDING|eerie-a\n18_0|X|eerie-b\n");
  ASSERT_EQ(queue.size(), 2u);
  EXPECT_EQ(queue.at(17).name, "eerie-a");
  EXPECT_THAT(queue.at(17).states, UnorderedElementsAre(Pair(4, "RUNNING"), Pair(5, "PENDING")));
  EXPECT_TRUE(queue.at(18).contains(0));
  EXPECT_FALSE(queue.at(18).contains(1));
}

TEST(SqueueAnswer, ExpandsRangesWithLimitsAndSteps) {
  const Queue queue = parse_queue("12_[3-5,9,20-24:2%2]|PENDING|e\n");
  std::vector<int> indices;
  for (const auto& [index, state] : queue.at(12).states) indices.push_back(index);
  EXPECT_THAT(indices, testing::ElementsAre(3, 4, 5, 9, 20, 22, 24));
  EXPECT_FALSE(queue.at(12).more);
}

TEST(SqueueAnswer, TakesWhatItCannotReadOfAnArrayForStillThere) {
  for (const char* text : {"12_[1-3,...]|PENDING|e", "12_[5-|PENDING|e", "12_x|RUNNING|e",
                           "12|RUNNING|e", "12_[0-99999999999]|PENDING|e", "12_[1:0]|PENDING|e"}) {
    const Queue queue = parse_queue(text);
    ASSERT_TRUE(queue.contains(12)) << text;
    EXPECT_TRUE(queue.at(12).contains(77)) << text;
  }
}

TEST(SqueueAnswer, PassesOverLinesThatAreNoJobs) {
  EXPECT_THAT(parse_queue(""), IsEmpty());
  EXPECT_THAT(parse_queue("\n\nslurm is slow today\n||\n"), IsEmpty());
}

TEST(SqueueAnswer, KeepsNamesWithTheirBars) {
  EXPECT_EQ(parse_queue("12_1|RUNNING|a|b\n").at(12).name, "a|b");
}

TEST(Indices, AreWrittenAsRanges) {
  EXPECT_EQ(index_ranges({}), "");
  EXPECT_EQ(index_ranges({7}), "7");
  EXPECT_EQ(index_ranges({0, 1, 2, 3}), "0-3");
  EXPECT_EQ(index_ranges({3, 4, 5, 9, 11, 12}), "3-5,9,11-12");
}

TEST(ClusterConfig, GivesTheLargestArray) {
  EXPECT_EQ(max_array_size("MaxArraySize            = 1001\n"), 1001);
  EXPECT_EQ(max_array_size("A = 1\nMaxArraySize=75001\nMaxJobCount = 5"), 75001);
  EXPECT_EQ(max_array_size("MaxArraySizes = 3\n"), std::nullopt);
  EXPECT_EQ(max_array_size("MaxArraySize = many\n"), std::nullopt);
}

}  // namespace
}  // namespace eerie::slurm
