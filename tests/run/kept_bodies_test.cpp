#include "solver/run/kept_bodies.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <set>

#include "solver/base/file.hpp"
#include "solver/initial/bodies.hpp"
#include "tests/run/runs.hpp"

namespace eerie::run {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using particles::Body;
using test::differences;
using test::run_in;
using test::short_impact;
using test::TemporaryFolder;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const json another_impact = {{"impact", {{"v_imp_cm_per_s", 35}, {"theta_imp_deg", 30}}},
                             {"end", {{"time_s", 300}}}};

RunOptions with_bodies_in(const fs::path& folder) {
  RunOptions options;
  options.bodies = folder;
  return options;
}

std::set<fs::path> files_in(const fs::path& folder) {
  std::set<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.insert(entry.path());
  return files;
}

io::Snapshot end_without_kept_bodies(const Scene& scene) {
  const TemporaryFolder folder;
  run_in(folder, scene);
  return io::read_snapshot(folder / "final.hdf5");
}

TEST(KeptBodies, ServeAnotherImpactWithTheSameBits) {
  const TemporaryFolder first, second, bodies;
  run_in(first, short_impact(), with_bodies_in(bodies / "shared"));
  EXPECT_EQ(files_in(bodies / "shared").size(), 2u);
  EXPECT_FALSE(fs::exists(first / "settling_target.hdf5"));
  const Scene scene = short_impact(another_impact);
  const auto told = run_in(second, scene, with_bodies_in(bodies / "shared"));
  EXPECT_THAT(told.notes, Contains(HasSubstr("taken at rest")).Times(2));
  EXPECT_THAT(differences(io::read_snapshot(second / "final.hdf5"), end_without_kept_bodies(scene)),
              IsEmpty());
}

TEST(KeptBodies, AreSharedWhereTheirMakingIsTheSameOnly) {
  const Scene scene = short_impact();
  const auto shares = [&](Body body, const json& changes) {
    return initial::body_hash(scene, body) == initial::body_hash(short_impact(changes), body);
  };
  EXPECT_TRUE(shares(Body::target, another_impact));
  EXPECT_TRUE(shares(Body::impactor, another_impact));
  EXPECT_TRUE(shares(Body::target, {{"impact", {{"q", 0.5}}}}));
  EXPECT_FALSE(shares(Body::impactor, {{"impact", {{"q", 0.5}}}}));
  EXPECT_TRUE(shares(Body::target, {{"impactor", {{"spin", {{"period_h", 9}}}}}}));
  EXPECT_FALSE(shares(Body::impactor, {{"impactor", {{"spin", {{"period_h", 9}}}}}}));
  EXPECT_FALSE(shares(Body::target, {{"target", {{"spin", {{"period_h", 9}}}}}}));
  EXPECT_TRUE(shares(Body::impactor, {{"target", {{"spin", {{"period_h", 9}}}}}}));
  for (const json& changes : {
           json{{"target", {{"radius_m", 60}}}},
           json{{"material", {{"rho0_kg_per_m3", 2000}}}},
           json{{"material", {{"drucker_prager", {{"phi_d_deg", 30}}}}}},
           json{{"material", {{"drucker_prager", {{"cohesion_Pa", 1}}}}}},
           json{{"numerics", {{"seed", 2}}}},
           json{{"numerics", {{"particles_per_target", 400}}}},
           json{{"numerics", {{"cfl", 0.5}}}},
           json{{"numerics", {{"scheme", "libersky-petschek-2018"}}}},
       })
    for (const Body body : {Body::target, Body::impactor})
      EXPECT_FALSE(shares(body, changes)) << changes << ' ' << initial::name_of(body);
  EXPECT_NE(initial::body_hash(scene, Body::target), initial::body_hash(scene, Body::impactor));
}

/// What `spoil` makes of each kept file is passed over, and replaced by a body made anew.
void expect_passed_over(const std::function<void(const fs::path&)>& spoil) {
  const TemporaryFolder first, second, bodies;
  const Scene scene = short_impact();
  run_in(first, scene, with_bodies_in(bodies / "shared"));
  const auto kept = files_in(bodies / "shared");
  for (const fs::path& file : kept) spoil(file);
  const auto told = run_in(second, scene, with_bodies_in(bodies / "shared"));
  EXPECT_THAT(told.notes, Not(Contains(HasSubstr("taken at rest"))));
  EXPECT_THAT(differences(io::read_snapshot(first / "final.hdf5"),
                          io::read_snapshot(second / "final.hdf5")),
              IsEmpty());
  EXPECT_EQ(files_in(bodies / "shared"), kept);
  for (const fs::path& file : kept) EXPECT_NO_THROW(io::read_snapshot(file));
}

TEST(KeptBodies, ThatAreDamagedArePassedOver) {
  expect_passed_over([](const fs::path& file) { fs::resize_file(file, fs::file_size(file) / 2); });
}

TEST(KeptBodies, ThatAreNamedAsOthersArePassedOver) {
  const TemporaryFolder folder, bodies;
  run_in(folder, short_impact({{"numerics", {{"seed", 2}}}}), with_bodies_in(bodies / "others"));
  const fs::path other = *files_in(bodies / "others").begin();
  expect_passed_over([&](const fs::path& file) {
    fs::copy_file(other, file, fs::copy_options::overwrite_existing);
  });
}

TEST(KeptBodies, ThatArePipesHoldNobodyUp) {
  expect_passed_over([](const fs::path& file) {
    fs::remove(file);
    ASSERT_EQ(::mkfifo(file.c_str(), 0600), 0);
  });
}

TEST(KeptBodies, ThatCannotBeKeptAreNotedAndTheRunGoesOn) {
  const TemporaryFolder folder;
  install_text(folder / "no-folder", "");
  const auto told = run_in(folder, short_impact(), with_bodies_in(folder / "no-folder"));
  EXPECT_EQ(told.summary.end, RunEnd::finished);
  EXPECT_THAT(told.notes, Contains(HasSubstr("is not kept for other runs")).Times(2));
}

}  // namespace
}  // namespace eerie::run
