#include "campaign/job_folder/history.hpp"

#include <gtest/gtest.h>

#include "solver/base/file.hpp"
#include "tests/campaign/job_folder/job_files.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::job_folder {
namespace {

TEST(History, GoesOnWhereAnEarlierAttemptStopped) {
  const test::TemporaryFolder folder;
  const auto found = test::sample_analysis().remnants;
  {
    History first(folder / "history.csv");
    for (const double time : {500.0, 1000.0, 1500.0}) first.add({history_row(time, found)});
  }
  // The checkpoint was older than the last row: the run comes by 1500 s once more.
  History second(folder / "history.csv");
  second.add({history_row(1500, found)});
  HistoryRow last = history_row(2000, found);
  double number = 0.1;  // every column of its own
  visit_columns(last, [&](const char*, auto& value) {
    if constexpr (std::is_same_v<decltype(value), double&>)
      if (&value != &last.time_s && &value != &last.b_over_a) value = (number += 1.0 / 7);
  });
  second.add({last});
  const History read_back(folder / "history.csv");
  ASSERT_EQ(read_back.rows().size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(read_back.rows()[i].time_s, 500.0 * static_cast<double>(i + 1));
  EXPECT_DOUBLE_EQ(read_back.rows()[3].b_over_a, 0.24);
  EXPECT_EQ(read_back.rows()[3].n_remnants, 2);
  std::vector<double> written, read;
  visit_columns(last, [&](const char*, auto& value) { written.push_back(value); });
  HistoryRow same = read_back.rows()[3];
  visit_columns(same, [&](const char*, auto& value) { read.push_back(value); });
  EXPECT_EQ(read, written);
}

TEST(History, LeavesOutALineThatWasCutOff) {
  const test::TemporaryFolder folder;
  History history(folder / "history.csv");
  for (const double time : {500.0, 1000.0})
    history.add({history_row(time, test::sample_analysis().remnants)});
  const std::string text = read_file(folder / "history.csv");
  install_text(folder / "torn.csv", text.substr(0, text.size() - 20));
  EXPECT_EQ(read_history(folder / "torn.csv").size(), 1u);
  // Its last number may be another one with a digit less: only a whole line counts.
  install_text(folder / "torn.csv", text.substr(0, text.size() - 1));
  EXPECT_EQ(read_history(folder / "torn.csv").size(), 1u);
  EXPECT_TRUE(read_history(folder / "missing.csv").empty());
}

TEST(History, GoesOnBehindALineThatWasCutOff) {
  const test::TemporaryFolder folder;
  const auto found = test::sample_analysis().remnants;
  {
    History first(folder / "history.csv");
    for (const double time : {500.0, 1000.0}) first.add({history_row(time, found)});
  }
  const std::string whole = read_file(folder / "history.csv");
  install_text(folder / "history.csv", whole.substr(0, whole.size() - 20));
  History second(folder / "history.csv");
  second.add({history_row(1000, found)});
  EXPECT_EQ(read_file(folder / "history.csv"), whole);
}

TEST(History, SaysThatAFileIsGoneToWhichItWasAdding) {
  const test::TemporaryFolder folder;
  const auto found = test::sample_analysis().remnants;
  History history(folder / "history.csv");
  history.flush();  // nothing yet
  history.add({history_row(500, found)});
  history.flush();
  std::filesystem::remove(folder / "history.csv");
  EXPECT_THROW(history.add({history_row(1000, found)}), EnvironmentError);
  // Tried again, all rows are there.
  history.add({history_row(1000, found)});
  EXPECT_EQ(read_history(folder / "history.csv").size(), 2u);
}

TEST(History, KeepsEachRemnantOfOneMomentWithTheSameBits) {
  const test::TemporaryFolder folder;
  RowLog<ending::RemnantLook> first(folder / "remnants.csv");
  const std::vector<ending::RemnantLook> pair = {{500, 1, 0.5, 1.0 / 3, 120, 0.7, 0.6, 0.1},
                                                 {500, 2, 0.4, 0.9, 110, 0.8, 0.5, 0}};
  first.add(pair);
  first.add({{1000, 1, 0.9, 0.5, 200, 0.3, 0.2, 0.11}});
  RowLog<ending::RemnantLook> second(folder / "remnants.csv");
  ASSERT_EQ(second.rows().size(), 3u);
  EXPECT_EQ(second.rows()[0].target_fraction, 1.0 / 3);
  EXPECT_EQ(second.rows()[1].rank, 2);
  second.add(pair);  // gone on from before 500 s: what came later gives way
  EXPECT_EQ(RowLog<ending::RemnantLook>(folder / "remnants.csv").rows().size(), 2u);
}

std::vector<HistoryRow> rows_of(const std::vector<std::pair<double, double>>& masses) {
  std::vector<HistoryRow> rows;
  for (const auto& [first, second] : masses) {
    HistoryRow row;
    row.n_remnants = 2, row.m_1_over_m_total = first, row.m_2_over_m_total = second;
    rows.push_back(row);
  }
  return rows;
}

TEST(History, SeesBodiesThatCameApartAfterTheyTouched) {
  EXPECT_TRUE(separated_after_contact(rows_of({{.5, .5}, {1, 0}, {.5, .48}, {.98, 0}}), 1));
}

TEST(History, DoesNotTakeTheApproachOrAFragmentForASeparation) {
  EXPECT_FALSE(separated_after_contact(rows_of({{.5, .5}, {.5, .5}, {1, 0}, {1, 0}}), 1));
  EXPECT_FALSE(separated_after_contact(rows_of({{.5, .5}, {1, 0}, {.9, .08}}), 1));
  EXPECT_FALSE(separated_after_contact({}, 1));
}

TEST(History, MeasuresTheSeparatedBodiesAgainstASmallImpactor) {
  // q = 1/4: the impactor holds 0.2 of the mass, and half of that is a body.
  EXPECT_TRUE(separated_after_contact(rows_of({{.8, .2}, {1, 0}, {.85, .12}}), 0.25));
}

}  // namespace
}  // namespace eerie::job_folder
