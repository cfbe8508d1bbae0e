#include "campaign/serve/views/particles.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <nlohmann/json.hpp>

#include "campaign/job_folder/job_directory.hpp"
#include "solver/base/error.hpp"
#include "solver/initial/bodies.hpp"
#include "solver/io/snapshot.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::serve {
namespace {
using nlohmann::json;

/// What the page reads.
struct Unpacked {
  json head;
  std::vector<float> x, depth, speed, pressure;
  std::string body, remnant;
};

Unpacked unpack(const std::string& bytes) {
  EXPECT_EQ(bytes.substr(0, 4), "eer1");
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 4, 4);
  EXPECT_EQ(length % 4, 0u) << "or the numbers behind it could not be read as they lie";
  Unpacked u;
  u.head = json::parse(bytes.substr(8, length));
  const auto n = u.head.at("n").get<std::size_t>();
  std::size_t at = 8 + length;
  const auto floats = [&](std::size_t count) {
    std::vector<float> values(count);
    std::memcpy(values.data(), bytes.data() + at, 4 * count);
    at += 4 * count;
    return values;
  };
  u.x = floats(3 * n), u.depth = floats(n), u.speed = floats(n), u.pressure = floats(n);
  u.body = bytes.substr(at, n), u.remnant = bytes.substr(at + n, n);
  EXPECT_EQ(bytes.size(), at + 2 * n);
  return u;
}

/// Two bodies before their impact, as a job directory has them.
class Particles : public testing::Test {
 protected:
  Particles() {
    const Scene scene = parse_scene({{"numerics", {{"particles_per_target", 400}}}});
    snapshot.scene = scene;
    snapshot.state = initial::make_impact(scene);
    snapshot.pressure.resize(snapshot.state.size());
    for (std::size_t i = 0; i < snapshot.state.size(); ++i)
      snapshot.pressure[i] = 10.0 * snapshot.state.id[i];
    io::write_snapshot(directory.first_snapshot(), snapshot);
  }
  Unpacked all(std::size_t most = most_particles) {
    return unpack(particles(directory, "snapshot_0000.hdf5", most));
  }
  test::TemporaryFolder folder;
  job_folder::JobDirectory directory{folder.path()};
  io::Snapshot snapshot;
};

TEST_F(Particles, AreThoseOfTheSnapshotAboutTheirCentreOfMass) {
  const Unpacked u = all();
  const auto& state = snapshot.state;
  ASSERT_EQ(u.head.at("n"), state.size());
  Vec3 centre;
  for (const Vec3& x : state.x) centre += x / static_cast<double>(state.size());
  for (std::size_t i = 0; i < state.size(); ++i) {
    EXPECT_NEAR(u.x[3 * i], state.x[i].x - centre.x, 1e-3);
    EXPECT_NEAR(u.x[3 * i + 2], state.x[i].z - centre.z, 1e-3);
    EXPECT_EQ(static_cast<std::uint8_t>(u.body[i]), state.body[i]);
    EXPECT_FLOAT_EQ(u.pressure[i], static_cast<float>(snapshot.pressure[i]));
  }
}

TEST_F(Particles, LieNoDeeperThanTheirBodyIsThick) {
  const double radius = snapshot.scene.target.radius_m;
  const Unpacked u = all();
  double deepest = 0;
  for (const float depth : u.depth) {
    EXPECT_GE(depth, 0);
    EXPECT_LE(depth, radius);
    deepest = std::max<double>(deepest, depth);
  }
  EXPECT_GT(deepest, 0.8 * radius) << "some particle is near the middle";
}

TEST_F(Particles, OfTwoBodiesAreTwoRemnantsWithTheAxesOfSpheres) {
  const Unpacked u = all();
  ASSERT_EQ(u.head.at("remnants").size(), 2u);
  std::map<char, std::map<char, int>> ranks_of_bodies;
  for (std::size_t i = 0; i < u.body.size(); ++i) ++ranks_of_bodies[u.body[i]][u.remnant[i]];
  EXPECT_EQ(ranks_of_bodies[0].size(), 1u) << "all of the target is in one of them";
  for (const json& remnant : u.head.at("remnants")) {
    const auto lengths = remnant.at("lengths").get<std::array<double, 3>>();
    EXPECT_GT(lengths[2] / lengths[0], 0.9);
    const auto a = remnant.at("axes").get<std::array<std::array<double, 3>, 3>>();
    for (int k = 0; k < 3; ++k)
      for (int l = 0; l < 3; ++l)
        EXPECT_NEAR(a[k][0] * a[l][0] + a[k][1] * a[l][1] + a[k][2] * a[l][2], k == l, 1e-9);
  }
  for (const float speed : u.speed) EXPECT_LT(speed, 1e-4) << "bodies at rest in themselves, m/s";
}

TEST_F(Particles, AreThinnedTheSameWayInEverySnapshot) {
  const Unpacked few = all(100);
  EXPECT_LE(few.head.at("n").get<std::size_t>(), 100u);
  EXPECT_GE(few.head.at("n").get<std::size_t>(), 50u);
  EXPECT_EQ(few.head.at("of"), snapshot.state.size());
  std::ranges::reverse(snapshot.state.x);  // another order in memory, the same ids
  const auto reversed = [](auto& array) { std::ranges::reverse(array); };
  reversed(snapshot.state.id), reversed(snapshot.state.body), reversed(snapshot.state.v);
  reversed(snapshot.state.rho), reversed(snapshot.state.S), reversed(snapshot.pressure);
  io::write_snapshot(directory.first_snapshot(), snapshot);
  std::vector<float> before = few.pressure, after = all(100).pressure;
  std::ranges::sort(before), std::ranges::sort(after);
  EXPECT_EQ(before, after);
}

TEST_F(Particles, OfOtherFilesAreRefused) {
  for (const char* name : {"", "snapshot_0001.hdf5", "../a.sqlite", "/etc/passwd", "result.json"})
    EXPECT_THROW(particles(directory, name), InputError) << name;
}

}  // namespace
}  // namespace eerie::serve
