#include "db/views/view.hpp"

#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>

#include "db/jobs/jobs.hpp"
#include "db/store/bind.hpp"
#include "db/store/error.hpp"
#include "db/store/settings.hpp"
#include "db/views/query.hpp"
#include "tests/db/jobs/sample_jobs.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::db {
namespace {
using test::sample_jobs;
using test::sample_result;
using testing::ElementsAre;
using testing::IsEmpty;

/// Four results, v = 15 to 18: b/a 0.2 to 0.5, the last of another class and without a spin; two
/// remnants each. A sweep "first" has the first two jobs alone.
class Views : public testing::Test {
 protected:
  Views() {
    const std::vector<NewJob> jobs = sample_jobs(4);
    first = add_sweep(connection, "first", "{}", std::span(jobs).first(2)).sweep;
    add_sweep(connection, "all", "{}", jobs);
    for (const Job& job : db::jobs(connection, {})) {
      const double shape = 0.2 + (job.v_imp_cm_per_s - 15) / 10;
      Result result = sample_result(shape);
      if (job.v_imp_cm_per_s == 18) result.outcome_class = "hit-and-run", result.period_h = {};
      begin_attempts(connection, std::vector{Start{job.id, "here", "1", "0.1.0"}});
      finish(connection, job.id, test::ended(ExitReason::finished), result,
             std::vector<Remnant>{Remnant{.rank = 1, .mass_kg = 10 * shape, .b_over_a = shape},
                                  Remnant{.rank = 2, .mass_kg = shape, .b_over_a = 0.9}});
    }
  }
  std::vector<double> speeds(ViewQuery query) {
    query.columns = {"v_imp_cm_per_s"};
    std::vector<double> found;
    for (const auto& row : rows(connection, query).rows) found.push_back(std::get<double>(row[0]));
    return found;
  }
  std::vector<double> speeds_where(const Condition& condition) {
    return speeds({.conditions = {condition}});
  }

  test::TemporaryFolder folder;
  Connection connection{folder / "a.sqlite", Access::write};
  std::int64_t first = 0;
};

TEST_F(Views, SayTheSchemeOfAJobTheFolderOfItsFilesAndItsDebris) {
  NewJob job = sample_jobs(5).back();
  job.hash = "0123456789abcdef0123";
  job.scene = R"({"numerics": {"scheme": "closing-gaps"}})";
  add_sweep(connection, "schemes", "{}", std::vector{job});
  const std::int64_t id = db::jobs(connection, {.selection = {.hashes = {"0123"}}}).at(0).id;
  begin_attempts(connection, std::vector{Start{id, "here", "1", "0.1.0"}});
  finish(connection, id, test::ended(ExitReason::finished), sample_result(0.5),
         std::vector<Remnant>{Remnant{.rank = 1, .mass_over_total = 0.75},
                              Remnant{.rank = 2, .mass_over_total = 0.125}});
  const std::vector<Condition> this_job = {{.column = "job", .lo = id, .hi = id}};
  const auto read = [&] {
    return rows(connection,
                {.columns = {"scheme", "job_folder", "debris_fraction"}, .conditions = this_job})
        .rows.at(0);
  };
  EXPECT_EQ(read()[0], Cell("closing-gaps"));
  EXPECT_EQ(read()[2], Cell(0.125));
  EXPECT_EQ(read()[1], Cell());  // until a manager has worked on the database
  set(connection, "database_name", "a.sqlite");
  EXPECT_EQ(read()[1], Cell("a.sqlite.jobs/0123456789abcdef"));
  set(connection, "jobs_folder", "/scratch/jobs");
  EXPECT_EQ(read()[1], Cell("/scratch/jobs/0123456789abcdef"));
  for (const View view : {View::remnants, View::maps, View::all_jobs}) {
    const ViewRows found = rows(
        connection, {.view = view, .conditions = {{.column = "scheme", .words = {"closing-*"}}}});
    EXPECT_EQ(found.rows.size(), view == View::remnants ? 2u : 1u) << name(view_names, view);
  }
}

TEST_F(Views, HaveTheUnitAndMeaningOfEveryColumnInATableBesideThem) {
  connection.read([](SQLite::Database& sql) {
    SQLite::Statement select(sql,
                             "SELECT unit, meaning FROM units WHERE view = ? AND column_name = ?");
    for (const View view : {View::results, View::remnants, View::maps}) {
      SQLite::Statement columns(sql, "SELECT name FROM pragma_table_info(?)");
      bind_all(columns, name(view_names, view));
      while (columns.executeStep()) {
        const std::string column = columns.getColumn(0).getString();
        bind_all(select, name(view_names, view), column);
        ASSERT_TRUE(select.executeStep()) << column;
        EXPECT_EQ(select.getColumn(0).getString(), unit_in_name(column)) << column;
        EXPECT_EQ(select.getColumn(1).getString(), meaning_of(view, column)->meaning) << column;
      }
    }
  });
}

TEST_F(Views, NumberSweepsOfOneNameThatDiffer) {
  const std::vector<NewJob> jobs = sample_jobs(4);
  const auto add = [&](const char* document, std::size_t jobs_of_it) {
    return add_sweep(connection, "first", document, std::span(jobs).first(jobs_of_it)).label;
  };
  EXPECT_EQ(add("{}", 2), "first");
  EXPECT_EQ(add(R"({"other": 1})", 3), "first@2");
  EXPECT_EQ(add("{}", 2), "first");
  std::vector<std::string> labels;
  for (const SweepStatus& sweep : sweep_status(connection)) labels.push_back(sweep.label);
  EXPECT_THAT(labels, ElementsAre("first", "all", "first@2"));
  const auto chosen = [&](const char* sweep) {
    return db::jobs(connection, {.selection = {.sweep = sweep}}).size();
  };
  EXPECT_EQ(chosen("first"), 3u);  // all of the name
  EXPECT_EQ(chosen("first@1"), 2u);
  EXPECT_EQ(chosen("first@2"), 3u);
  EXPECT_EQ(chosen("first@3"), 0u);
}

TEST_F(Views, FindRowsByRangesWordsAndMissingValues) {
  EXPECT_THAT(speeds({}), ElementsAre(15, 16, 17, 18));
  EXPECT_THAT(speeds_where({.column = "b_over_a", .lo = 0.25, .hi = 0.4}), ElementsAre(16, 17));
  EXPECT_THAT(speeds_where({.column = "b_over_a", .hi = 0.25}), ElementsAre(15));
  EXPECT_THAT(speeds_where({.column = "class", .words = {"hit*"}}), ElementsAre(18));
  EXPECT_THAT(speeds_where({.column = "class", .words = {"hit", "*merging"}}),
              ElementsAre(15, 16, 17));
  EXPECT_THAT(speeds_where({.column = "period_h", .empty = true}), ElementsAre(18));
  EXPECT_THAT(speeds({.conditions = {{.column = "b_over_a", .lo = 0.3},
                                     {.column = "class", .words = {"perfect-merging"}}}}),
              ElementsAre(16, 17));
}

TEST_F(Views, TakeTheContraryOfAConditionMissingValuesIncluded) {
  EXPECT_THAT(speeds_where({.column = "class", .words = {"hit*"}, .negated = true}),
              ElementsAre(15, 16, 17));
  EXPECT_THAT(speeds_where({.column = "period_h", .lo = 0, .negated = true}), ElementsAre(18));
  EXPECT_THAT(speeds_where({.column = "period_h", .empty = true, .negated = true}),
              ElementsAre(15, 16, 17));
}

TEST_F(Views, SortMissingValuesLastAndStopAtTheLimit) {
  EXPECT_THAT(speeds({.sort = {{"v_imp_cm_per_s", true}}, .limit = 2}), ElementsAre(18, 17));
  EXPECT_THAT(speeds({.sort = {{"period_h", false}, {"b_over_a", true}}}),
              ElementsAre(17, 16, 15, 18));
  EXPECT_THAT(speeds({.sort = {{"period_h", true}}}).back(), 18);
}

TEST_F(Views, RemnantsMayBeChosenByWhatTheirImpactIs) {
  const ViewRows found =
      rows(connection,
           {.view = View::remnants,
            .columns = {"rank", "v_imp_cm_per_s"},
            .conditions = {{.column = "class", .words = {"hit*"}}, {.column = "rank", .lo = 2}}});
  ASSERT_EQ(found.rows.size(), 1u);
  EXPECT_THAT(found.rows[0], ElementsAre(Cell(std::int64_t{2}), Cell(18.0)));
  EXPECT_TRUE(is_condition_column(connection, View::remnants, "class"));
  EXPECT_FALSE(is_condition_column(connection, View::maps, "end_reason"));
}

TEST_F(Views, KnowTheJobsOfASweep) {
  EXPECT_THAT(speeds({.sweeps = {first}}), ElementsAre(15, 16));
  EXPECT_THAT(speeds({.sweeps = {first + 100}}), IsEmpty());
  EXPECT_THROW(rows(connection, {.view = View::maps, .sweeps = {first}}), Error);
}

TEST_F(Views, TakeNoTextForAColumnThatIsNone) {
  for (const char* name : {"nothing", "b_over_a\" OR 1=1 --", "1", ""}) {
    EXPECT_THROW(rows(connection, {.columns = {name}}), Error) << name;
    EXPECT_THROW(rows(connection, {.sort = {{name}}}), Error) << name;
    EXPECT_THROW(rows(connection, {.conditions = {{.column = name, .lo = 0}}}), Error) << name;
  }
  EXPECT_THAT(speeds_where({.column = "class", .words = {"x' OR '1'='1"}}), IsEmpty());
}

TEST_F(Views, ShowAColumnOfALaterSchemaByThemselves) {
  connection.write([](SQLite::Database& sql) {
    sql.exec(
        "DROP VIEW maps;"
        "CREATE VIEW maps AS SELECT q, phi_d_deg, v_imp_cm_per_s, 45.5 AS obliquity_deg FROM jobs");
  });
  const ViewRows found = rows(connection, {.view = View::maps, .limit = 1});
  ASSERT_TRUE(found.find("obliquity_deg"));
  EXPECT_EQ(found.rows.at(0).at(*found.find("obliquity_deg")), Cell(45.5));
  EXPECT_FALSE(found.find("theta_imp_deg"));
}

TEST_F(Views, OfAllJobsHaveThoseWithoutAResultToo) {
  NewJob waiting = sample_jobs(5).back();
  add_sweep(connection, "later", "{}", std::vector{waiting});
  const Connection reader(folder / "a.sqlite", Access::read);
  const ViewQuery all{.view = View::all_jobs, .columns = {"v_imp_cm_per_s", "state", "b_over_a"}};
  const ViewRows found = rows(reader, all);
  ASSERT_EQ(found.rows.size(), 5u);
  EXPECT_EQ(found.rows[0][1], Cell("done"));
  EXPECT_EQ(found.rows[4][1], Cell("pending"));
  EXPECT_EQ(found.rows[4][2], Cell());
  ViewQuery page = all;
  page.limit = 2, page.offset = 3;
  EXPECT_EQ(rows(reader, page).rows[0][0], Cell(18.0));
  EXPECT_EQ(rows(reader, page).rows.size(), 2u);
}

TEST_F(Views, AreSummedUpWhateverTheirLimit) {
  ViewQuery query{.view = View::all_jobs, .limit = 1};
  const std::vector<std::string> columns = {"q", "v_imp_cm_per_s", "class", "period_h", "state"};
  ViewSummary found = summary(connection, query, columns);
  EXPECT_EQ(found.rows, 4);
  EXPECT_THAT(found.differing, ElementsAre("v_imp_cm_per_s", "class", "period_h"))
      << "a missing value is another one";
  query.conditions = {{.column = "class", .words = {"perfect-merging"}}};
  found = summary(connection, query, columns);
  EXPECT_EQ(found.rows, 3);
  EXPECT_THAT(found.differing, ElementsAre("v_imp_cm_per_s"));
  EXPECT_THROW(summary(connection, query, {"no such"}), Error);
}

}  // namespace
}  // namespace eerie::db
