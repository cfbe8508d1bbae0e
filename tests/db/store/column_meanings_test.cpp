#include "db/store/column_meanings.hpp"

#include <gmock/gmock.h>

#include <set>

#include "db/store/bind.hpp"
#include "db/views/view.hpp"
#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/paths.hpp"

namespace eerie::db {
namespace {

constexpr View views[] = {View::results, View::remnants, View::maps, View::all_jobs};

class ColumnMeanings : public testing::Test {
 protected:
  test::TemporaryFolder folder;
  Connection connection{folder / "a.sqlite", Access::write};
};

TEST_F(ColumnMeanings, AreThereForEveryColumnOfEveryViewWithTheUnitOfItsName) {
  for (const View view : views)
    for (const ViewColumn& column : columns(connection, view)) {
      const ColumnMeaning* known = meaning_of(view, column.name);
      ASSERT_NE(known, nullptr) << name(view_names, view) << "." << column.name
                                << " needs a line in the table of db/store/column_meanings.cpp";
      EXPECT_FALSE(known->meaning.empty()) << column.name;
      EXPECT_EQ(known->unit, unit_in_name(column.name)) << column.name;
    }
}

TEST_F(ColumnMeanings, AreOfColumnsThatSomeViewHas) {
  for (const ColumnMeaning& entry : column_meanings()) {
    bool found = false;
    for (const View view : views)
      for (const ViewColumn& column : columns(connection, view))
        found = found || &entry == meaning_of(view, column.name);
    EXPECT_TRUE(found) << entry.name << " is in no view, or another line stands before it";
  }
}

TEST_F(ColumnMeanings, AreWordsWhereTheTableHoldsText) {
  for (const View view : views)
    for (const ViewColumn& column : columns(connection, view)) {
      if (column.declared.empty()) continue;
      EXPECT_EQ(kind_of(view, column) == ColumnKind::word, column.declared == "TEXT")
          << column.name;
    }
}

TEST_F(ColumnMeanings, AreInTheDocumentationWithNameAndUnit) {
  const std::string page = read_file(test::source_folder() / "docs/reference/database.md");
  for (const View view : views)
    for (const ViewColumn& column : columns(connection, view))
      EXPECT_THAT(page, testing::HasSubstr("`" + column.name + "`")) << name(view_names, view);
}

TEST(UnitInName, IsTheLongestEnding) {
  EXPECT_EQ(unit_in_name("v_imp_cm_per_s"), "cm/s");
  EXPECT_EQ(unit_in_name("vx_m_per_s"), "m/s");
  EXPECT_EQ(unit_in_name("wall_s"), "s");
  EXPECT_EQ(unit_in_name("bulk_density_kg_per_m3"), "kg/m^3");
  for (const char* name : {"steps", "b_over_a_min", "m_lr_over_m_total", "hash", "jobs"})
    EXPECT_EQ(unit_in_name(name), "") << name;
}

}  // namespace
}  // namespace eerie::db
