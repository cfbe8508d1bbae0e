#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "solver/base/error.hpp"
#include "solver/step/solver.hpp"
#include "tests/proof/lab.hpp"

namespace eerie::step {
namespace {
using nlohmann::json;

constexpr long side = 8, height = 5;  // of each block, in spacings of 1 m

/// Two blocks of rubble of the reference density, the upper one `gap` metres (from layer to layer)
/// above the lower one, in a box: nothing moves but up and down.
particles::State two_blocks(double gap) {
  particles::State state = proof::lattice_block({0, 0, 0}, {side, side, 2 * height}, 1, 2700);
  for (Vec3& x : state.x)
    if (x.z > height) x.z += gap - 1;
  return state;
}

/// Mean distance of the two layers that face each other, m.
double gap_of(const particles::State& s) {
  double lower = 0, upper = 0;
  int lowers = 0, uppers = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const long layer = s.id[i] % (2 * height);
    if (layer == height - 1) lower += s.x[i].z, ++lowers;
    if (layer == height) upper += s.x[i].z, ++uppers;
  }
  return upper / uppers - lower / lowers;
}

/// A box around the blocks, under a weak gravity.
Scene boxed(double void_density, const char* voids = "all", const json& changes = json::object()) {
  json walls = {proof::wall("z_low", 0, "slip")};
  for (const char* face : {"x_low", "y_low"}) walls.push_back(proof::wall(face, 0, "slip"));
  for (const char* face : {"x_high", "y_high"}) walls.push_back(proof::wall(face, side, "slip"));
  json scene = {{"environment", {{"gravity_m_per_s2", {0, 0, -1e-4}}, {"walls", walls}}},
                {"numerics",
                 {{"gradient", "corrected-fully"},
                  {"integrator", "leapfrog-pece"},
                  {"viscosity_alpha", 0.3},
                  {"void_density", void_density},
                  {"voids", voids}}}};
  scene.merge_patch(changes);
  return proof::lab_scene(scene);
}

/// Where the upper block comes to rest, m.
double gap_at_rest(double void_density, const char* voids = "all") {
  Solver solver(boxed(void_density, voids), two_blocks(2));
  while (solver.state().time < 400) solver.cycle(400);
  return gap_of(solver.state());
}

TEST(Voids, LetTwoSurfacesComeAsCloseAsTheLayersOfABody) {
  const double held_apart = gap_at_rest(0), closed = gap_at_rest(0.95);
  EXPECT_GT(held_apart, 1.35);  // the kernel reaches 2.4 spacings
  EXPECT_LT(closed, 1.2);
  EXPECT_GT(closed, 0.95);
}

TEST(Voids, OfGapsAloneLetSurfacesComeAsClose) {
  const double closed = gap_at_rest(0.95, "gaps");
  EXPECT_LT(closed, 1.2);
  EXPECT_GT(closed, 0.95);
}

/// Pressures of a block with a free surface after twenty cycles, Pa.
std::vector<double> pressures_with_a_free_surface(double void_density, const char* voids) {
  Solver solver(boxed(void_density, voids), two_blocks(1));
  for (int k = 0; k < 20; ++k) solver.cycle(1e9);
  return solver.pressure();
}

TEST(Voids, OfGapsAloneLeaveABodyThatHasNoneAsItIs) {
  const auto without = pressures_with_a_free_surface(0, "all");
  EXPECT_EQ(pressures_with_a_free_surface(0.95, "gaps"), without);
  EXPECT_NE(pressures_with_a_free_surface(0.95, "all"), without);
}

TEST(Voids, OfGapsAloneAreNotSeenInMatterThatBearsTension) {
  const json elastic = {{"material", proof::elastic_material(2700, 2.67e4, 2.27e4)}};
  Solver with(boxed(0.95, "gaps", elastic), two_blocks(2)),
      without(boxed(0, "all", elastic), two_blocks(2));
  for (int k = 0; k < 20; ++k) with.cycle(1e9), without.cycle(1e9);
  EXPECT_EQ(with.state().rho, without.state().rho);
  Solver everywhere(boxed(0.95, "all", elastic), two_blocks(2));
  for (int k = 0; k < 20; ++k) everywhere.cycle(1e9);
  EXPECT_NE(everywhere.state().rho, without.state().rho);
}

TEST(Voids, LeaveABodyWithoutAnyAsItIs) {
  // A block that fills its box has no surface but the upper one.
  const particles::State before = two_blocks(1);
  Solver solver(boxed(0.95), before);
  while (solver.state().time < 100) solver.cycle(100);
  EXPECT_NEAR(gap_of(solver.state()), 1, 1e-3);
  std::size_t pressed = 0;
  for (const double p : solver.pressure()) pressed += p > 0;
  EXPECT_GE(pressed, before.size() * (2 * height - 1) / (2 * height));
}

TEST(Voids, AreTheSameAfterARestart) {
  const Scene scene = boxed(0.95);
  Solver whole(scene, two_blocks(2));
  for (int k = 0; k < 6; ++k) whole.cycle(1e9);
  Solver first(scene, two_blocks(2));
  for (int k = 0; k < 3; ++k) first.cycle(1e9);
  Solver second(scene, first.state(), first.rates(), first.restart(), first.pressure());
  for (int k = 0; k < 3; ++k) second.cycle(1e9);
  EXPECT_EQ(second.state().rho, whole.state().rho);
  EXPECT_EQ(second.pressure(), whole.pressure());
  for (std::size_t i = 0; i < whole.state().size(); ++i)
    EXPECT_EQ(norm(second.state().x[i] - whole.state().x[i]), 0);
}

TEST(Voids, OfGapsAloneCloseWithEvolvingSmoothingLengths) {
  Solver solver(boxed(0.95, "gaps", {{"numerics", {{"smoothing", "evolving"}}}}), two_blocks(2));
  while (solver.state().time < 400) solver.cycle(400);
  EXPECT_LT(gap_of(solver.state()), 1.2);
  EXPECT_GT(gap_of(solver.state()), 0.95);
}

TEST(Voids, EverywhereAreSeenWithOneSmoothingLengthForAll) {
  try {
    parse_scene(
        {{"numerics", {{"void_density", 0.95}, {"voids", "all"}, {"smoothing", "evolving"}}}});
    FAIL() << "took both";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("numerics.void_density = 0.95"));
  }
}

TEST(Voids, KeepTheHashOfScenesThatHaveNone) {
  const json dual = {{"numerics", {{"scheme", "dual"}}}};
  const Scene off = parse_scene({{"numerics", {{"scheme", "dual"}, {"void_density", 0}}}});
  EXPECT_FALSE(to_json(off)["numerics"].contains("void_density"));
  EXPECT_FALSE(to_json(off)["numerics"].contains("voids"));
  EXPECT_EQ(scene_hash(off), scene_hash(parse_scene(dual)));
  EXPECT_NE(scene_hash(parse_scene({{"numerics", {{"scheme", "dual"}, {"void_density", 0.95}}}})),
            scene_hash(off));
}

}  // namespace
}  // namespace eerie::step
