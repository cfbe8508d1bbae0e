// A run whose angular momentum drifts ends, and everybody is told that it is not to be trusted.

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/program.hpp"

namespace eerie {
namespace {
using nlohmann::json;
using test::Ended;
using testing::HasSubstr;
using testing::Not;

/// Bodies as if welded: with so few particles 14 % of the angular momentum get lost as they touch.
json cohesive(double cohesion_Pa) {
  return {{"numerics", {{"particles_per_target", 100}, {"packing", "lattice"}}},
          {"impact", {{"separation", 1.3}, {"v_imp_cm_per_s", 30}}},
          {"material", {{"drucker_prager", {{"cohesion_Pa", cohesion_Pa}}}}},
          {"end", {{"time_s", 1500}}}};
}

class Drift : public testing::Test {
 protected:
  Drift() {
    install_text(folder / "cohesive.json", cohesive(1e12).dump());
    install_text(folder / "loose.json", cohesive(0).dump());
    json scene = cohesive(1e12);
    scene["impact"].erase("v_imp_cm_per_s");
    install_text(
        folder / "sweep.json",
        json{{"name", "cohesive"}, {"scene", scene}, {"grid", {{"v_imp_cm_per_s", {30}}}}}.dump());
  }
  Ended eerie(const std::vector<std::string>& arguments) {
    return test::eerie(folder.path(), arguments);
  }
  test::TemporaryFolder folder;
};

TEST_F(Drift, OfASingleRunIsToldAndNotedWithTheResult) {
  const Ended ended = eerie({"solve", "cohesive.json", "--out", "o", "--json"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.err, HasSubstr("warning: the angular momentum changed by"));
  const json run = json::parse(read_file(folder / "o/result.json")).at("run");
  EXPECT_GT(run.at("dL_over_L"), 0.01);
  EXPECT_EQ(run.at("warnings").size(), 1u);
  const Ended loose = eerie({"solve", "loose.json", "--out", "l"});
  EXPECT_THAT(loose.err, Not(HasSubstr("angular momentum")));
}

TEST_F(Drift, OfASweepIsTold) {
  const Ended ended = eerie({"run", "sweep.json", "--min-free-mb", "0"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.err, HasSubstr("1 of 1 results changed their angular momentum by more than 1"));
}

TEST_F(Drift, OfASweepOfAutomaticFidelityIsTold) {
  const Ended ended =
      eerie({"run", "sweep.json", "--min-free-mb", "0", "--fidelity", "auto", "--set",
             "end.time_s=1500", "--set", "numerics.particles_per_target=100", "--set",
             "numerics.packing=lattice", "--most-seeds", "4"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("results changed their angular momentum by more than 1 %"));
}

}  // namespace
}  // namespace eerie
