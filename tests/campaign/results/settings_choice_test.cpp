#include "campaign/results/settings_choice.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "db/jobs/job_settings.hpp"
#include "solver/base/error.hpp"
#include "tests/support/impact_database.hpp"

namespace eerie::results {
namespace {
using nlohmann::json;
using test::survey_scene;
using testing::HasSubstr;
using testing::Not;

class SettingsChoice : public testing::Test {
 protected:
  void add(const json& change) {
    json scene = survey_scene(1, 40, 20, 15, 1);
    scene.merge_patch(change);
    test::add_impact(connection, scene, 0.25);
  }
  std::set<std::int64_t> ids() {
    std::set<std::int64_t> all;
    for (const db::JobSettings& one : db::job_settings(connection)) all.insert(one.id);
    return all;
  }
  test::TemporaryFolder folder;
  db::Connection connection{folder / "a.sqlite", db::Access::write};
};

TEST_F(SettingsChoice, IsByFidelityWhereItTellsThemApartAndByNumberOtherwise) {
  add(json::object());
  add({{"numerics", {{"particles_per_target", 2000}}}});
  const std::string text = settings_choices(connection, ids());
  EXPECT_THAT(text, HasSubstr("--fidelity survey   numerics.particles_per_target=1000\n"));
  EXPECT_THAT(text, HasSubstr("--settings 2        numerics.particles_per_target=2000"));
}

TEST_F(SettingsChoice, NamesTheFieldsThatDifferAndNoOthers) {
  add({{"numerics", {{"cfl", 0.5}}}});
  add({{"numerics", {{"cfl", 0.6}}}, {"end", {{"time_s", 50000}}}});
  const std::string text = settings_choices(connection, ids());
  EXPECT_THAT(text, HasSubstr("end.time_s=100000, numerics.cfl=0.5\n"));
  EXPECT_THAT(text, HasSubstr("end.time_s=50000, numerics.cfl=0.6"));
  EXPECT_THAT(text, Not(HasSubstr("scheme")));
}

TEST_F(SettingsChoice, LeavesToTheNameOfASchemeWhatTheSchemeSets) {
  add({{"numerics", {{"scheme", "closing-gaps"}, {"kernel", "cubic-spline"}}}});
  add({{"numerics", {{"scheme", "libersky-petschek-2018"}, {"kernel", "wendland-c2"}}}});
  const std::string text = settings_choices(connection, ids());
  EXPECT_THAT(text, HasSubstr("numerics.scheme=closing-gaps, numerics.kernel=cubic-spline\n"));
  EXPECT_THAT(text, testing::EndsWith(
                        "numerics.scheme=libersky-petschek-2018, numerics.kernel=wendland-c2"));
}

TEST_F(SettingsChoice, IsAskedForOnlyWhereThereAreSeveral) {
  add(json::object());
  EXPECT_NO_THROW(require_one_settings(connection, ids()));
  add({{"numerics", {{"cfl", 0.5}}}});
  EXPECT_THROW(require_one_settings(connection, ids()), InputError);
}

}  // namespace
}  // namespace eerie::results
