#include "solver/io/snapshot.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "solver/io/units.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::io {
namespace {

using test::differences;
using test::random_snapshot;
using testing::HasSubstr;
using testing::IsEmpty;

/// The text of the InputError that reading `path` gives.
std::string refusal(const std::filesystem::path& path) {
  try {
    read_snapshot(path);
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(path.filename().string()));
    return error.what();
  }
  return "it was read";
}

/// The refusal of a snapshot whose content was spoilt before it was written.
template <class Spoil>
std::string refusal_of(Spoil spoil) {
  const test::TemporaryFolder folder;
  Snapshot snapshot = random_snapshot(200);
  spoil(snapshot);
  write_snapshot(folder / "spoilt.hdf5", snapshot);
  return refusal(folder / "spoilt.hdf5");
}

TEST(Snapshot, CheckpointComesBackWithTheSameBits) {
  const test::TemporaryFolder folder;
  for (const std::size_t n : {1u, 200u, 40000u}) {  // the last needs several chunks
    const Snapshot snapshot = random_snapshot(n);
    write_snapshot(folder / "a.hdf5", snapshot);
    EXPECT_THAT(differences(read_snapshot(folder / "a.hdf5"), snapshot), IsEmpty()) << n;
  }
}

TEST(Snapshot, TimeIsReadWithoutTheRest) {
  const test::TemporaryFolder folder;
  Snapshot snapshot = random_snapshot(200);
  snapshot.state.time = 1234.5;
  write_snapshot(folder / "a.hdf5", snapshot);
  EXPECT_EQ(snapshot_time(folder / "a.hdf5"), 1234.5);
  install_text(folder / "torn.hdf5", read_file(folder / "a.hdf5").substr(0, 500));
  EXPECT_THROW(snapshot_time(folder / "torn.hdf5"), InputError);
  EXPECT_THROW(snapshot_time(folder / "none.hdf5"), InputError);
}

TEST(Snapshot, PlainSnapshotComesBackWithoutRates) {
  const test::TemporaryFolder folder;
  const Snapshot snapshot = random_snapshot(200, false);
  write_snapshot(folder / "a.hdf5", snapshot);
  EXPECT_THAT(differences(read_snapshot(folder / "a.hdf5"), snapshot), IsEmpty());
}

TEST(Snapshot, HardNumbersSurvive) {
  const test::TemporaryFolder folder;
  Snapshot snapshot = random_snapshot(200);
  snapshot.state.x[0] = {-0.0, 5e-324, 1e9 + 1e-7};
  snapshot.state.x[1] = {-1e9 / 3, 0x1.fffffffffffffp-1, -1e-300};
  snapshot.state.v[2] = {1.7e308, -1.7e308, -0.0};
  write_snapshot(folder / "a.hdf5", snapshot);
  EXPECT_THAT(differences(read_snapshot(folder / "a.hdf5"), snapshot), IsEmpty());
}

TEST(Snapshot, ComparisonSeesASingleBit) {
  const Snapshot a = random_snapshot(200);
  Snapshot b = random_snapshot(200);
  b.state.x[7].y = std::nextafter(b.state.x[7].y, 1e9);
  b.rates.value().dS_dt[3].yz *= -1;
  b.restart.value().list_x[9].z += 1;
  EXPECT_THAT(differences(a, b),
              testing::ElementsAre("Coordinates", "StressRates", "ListCoordinates"));
}

TEST(Snapshot, EqualSnapshotsGiveEqualFiles) {
  const test::TemporaryFolder folder;
  write_snapshot(folder / "a.hdf5", random_snapshot(300));
  write_snapshot(folder / "b.hdf5", random_snapshot(300));
  EXPECT_EQ(read_file(folder / "a.hdf5"), read_file(folder / "b.hdf5"));
}

TEST(Snapshot, WritingLeavesNothingElseBehind) {
  const test::TemporaryFolder folder;
  write_snapshot(folder / "a.hdf5", random_snapshot(200));
  write_snapshot(folder / "a.hdf5", random_snapshot(300));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(Snapshot, UnphysicalContentIsRefusedWithItsName) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal_of([](Snapshot& s) { s.state.x[3].z = nan; }), HasSubstr("Coordinates[3]"));
  EXPECT_THAT(refusal_of([](Snapshot& s) { s.state.S[5].xz = 1 / 0.0; }),
              HasSubstr("DeviatoricStresses[5]"));
  EXPECT_THAT(refusal_of([](Snapshot& s) { s.state.rho[4] = 0; }), HasSubstr("Densities[4]"));
  EXPECT_THAT(refusal_of([](Snapshot& s) { s.state.id[4] = s.state.id[5]; }),
              HasSubstr("there twice"));
  EXPECT_THAT(refusal_of([](Snapshot& s) { s.state.id[4] = 200; }), HasSubstr("too large"));
  EXPECT_THAT(refusal_of([](Snapshot& s) { s.state.body[4] = 2; }), HasSubstr("BodyIDs[4]"));
  EXPECT_THAT(refusal_of([](Snapshot& s) { s.state.mass = 0; }), HasSubstr("ParticleMass"));
  EXPECT_THAT(refusal_of([](Snapshot& s) { s.state.h = nan; }), HasSubstr("SmoothingLength"));
  EXPECT_THAT(refusal_of([](Snapshot& s) { s.state.time = nan; }), HasSubstr("time"));
  EXPECT_THAT(refusal_of([](Snapshot& s) { s.pressure[1] = nan; }), HasSubstr("Pressures[1]"));
  EXPECT_THAT(refusal_of([](Snapshot& s) { s.rates->drho_dt[2] = nan; }),
              HasSubstr("DensityRates[2]"));
}

TEST(Snapshot, SceneInsideIsValidated) {
  EXPECT_THAT(refusal_of([](Snapshot& s) { s.scene.impact.q = 2; }),
              testing::AllOf(HasSubstr("impact.q"), HasSubstr("not a usable snapshot")));
}

TEST(Snapshot, EveryFieldOfTheTablesHasItsUnit) {
  Snapshot snapshot = random_snapshot(200);
  const auto has_unit = [](const char* name, const auto&) {
    EXPECT_NE(unit_of(name), nullptr) << name << " has no row in solver/io/units.hpp";
  };
  particles::visit_state(snapshot.state, has_unit);
  particles::visit_rates(snapshot.rates.value(), has_unit);
  particles::visit_restart(snapshot.restart.value(), has_unit);
}

TEST(Snapshot, MissingFileIsNamed) {
  const test::TemporaryFolder folder;
  EXPECT_THAT(refusal(folder / "nowhere.hdf5"), HasSubstr("no such snapshot"));
}

TEST(Snapshot, ArraysOfUnequalLengthAreNotWritten) {
  const test::TemporaryFolder folder;
  Snapshot snapshot = random_snapshot(200);
  snapshot.rates->drho_dt.pop_back();
  EXPECT_THROW(write_snapshot(folder / "a.hdf5", snapshot), std::logic_error);
  Snapshot empty;
  EXPECT_THROW(write_snapshot(folder / "a.hdf5", empty), std::logic_error);
  EXPECT_FALSE(std::filesystem::exists(folder / "a.hdf5"));
}

}  // namespace
}  // namespace eerie::io
