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

/// With a gradient that is not exact for a rotation, friction brakes every turning body.
json impact(const char* gradient) {
  return {
      {"numerics", {{"particles_per_target", 100}, {"packing", "lattice"}, {"gradient", gradient}}},
      {"impact", {{"separation", 1.3}, {"v_imp_cm_per_s", 30}}},
      {"end", {{"time_s", 1500}}}};
}

class Drift : public testing::Test {
 protected:
  Drift() {
    install_text(folder / "plain.json", impact("plain").dump());
    install_text(folder / "corrected.json", impact("corrected-fully").dump());
    json scene = impact("plain");
    scene["impact"].erase("v_imp_cm_per_s");
    install_text(
        folder / "sweep.json",
        json{{"name", "plain"}, {"scene", scene}, {"grid", {{"v_imp_cm_per_s", {30}}}}}.dump());
  }
  Ended eerie(const std::vector<std::string>& arguments) {
    return test::eerie(folder.path(), arguments);
  }
  test::TemporaryFolder folder;
};

TEST_F(Drift, OfASingleRunIsToldAndNotedWithTheResult) {
  const Ended ended = eerie({"solve", "plain.json", "--out", "o", "--json"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.err, HasSubstr("warning: the angular momentum changed by"));
  const json run = json::parse(read_file(folder / "o/result.json")).at("run");
  EXPECT_GT(run.at("dL_over_L"), 0.01);
  EXPECT_EQ(run.at("warnings").size(), 1u);
  const Ended corrected = eerie({"solve", "corrected.json", "--out", "l"});
  EXPECT_THAT(corrected.err, Not(HasSubstr("angular momentum")));
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
             "numerics.packing=lattice", "--set", "numerics.gradient=plain", "--most-seeds", "4"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("results changed their angular momentum by more than 1 %"));
}

}  // namespace
}  // namespace eerie
