#include "campaign/history.hpp"

#include <gtest/gtest.h>

#include "tests/campaign/job_files.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie {
namespace {

TEST(History, GoesOnWhereAnEarlierAttemptStopped) {
  const test::TemporaryFolder folder;
  const Analysis analysis = test::sample_analysis();
  {
    History first(folder / "history.csv");
    for (const double time : {500.0, 1000.0, 1500.0}) first.add(time, analysis);
  }
  // The checkpoint was older than the last row: the run comes by 1500 s once more.
  History second(folder / "history.csv");
  second.add(1500, analysis);
  second.add(2000, analysis);
  const History read_back(folder / "history.csv");
  ASSERT_EQ(read_back.rows().size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(read_back.rows()[i].time_s, 500.0 * static_cast<double>(i + 1));
  EXPECT_DOUBLE_EQ(read_back.rows()[3].b_over_a, 0.24);
  EXPECT_EQ(read_back.rows()[3].n_remnants, 2);
}

std::vector<HistoryRow> rows_of(const std::vector<std::pair<double, double>>& masses) {
  std::vector<HistoryRow> rows;
  for (const auto& [first, second] : masses) rows.push_back({0, 2, first, second, 1, 1});
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
}  // namespace eerie
