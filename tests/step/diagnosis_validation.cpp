#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "solver/base/bodies/sphere.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/error.hpp"
#include "solver/initial/bodies.hpp"
#include "solver/scene/two_materials.hpp"
#include "solver/sph/kernel.hpp"
#include "solver/step/diagnosis.hpp"
#include "solver/step/solver.hpp"
#include "tests/support/scenes.hpp"

namespace eerie::step {
namespace {

io::Snapshot body(const Scene& scene, const std::function<Vec3(const Vec3&)>& velocity) {
  io::Snapshot s{scene, initial::make_body(scene, particles::Body::target), {}, {}, {}};
  for (std::size_t i = 0; i < s.state.size(); ++i) s.state.v[i] = velocity(s.state.x[i]);
  return s;
}

/// Density and evenness by the sum over all pairs, in double precision.
struct BruteForce {
  double interior = 0, summed_density = 0;
  BruteForce(const Scene& scene, const particles::State& s) {
    using Kernel = sph::CubicSpline;
    const std::array<double, 2> rho0{scene.material.rho0_kg_per_m3,
                                     impactor_material(scene).rho0_kg_per_m3};
    for (std::size_t i = 0; i < s.size(); ++i) {
      const double h = std::cbrt(std::min(rho0[0], rho0[1]) / rho0[s.body[i]]) * s.h;
      double density = 0, neighbours = 0;
      Vec3 gradient;
      for (std::size_t j = 0; j < s.size(); ++j) {
        const Vec3 d = (s.x[i] - s.x[j]) / h;
        const double q = norm(d), volume = s.mass / rho0[s.body[j]] / cubed(h);
        if (q >= 2) continue;
        density += rho0[s.body[i]] * volume * Kernel::normalisation * Kernel::w(q);
        if (j == i) continue;
        neighbours += 1;
        gradient += volume * Kernel::normalisation * Kernel::dw_over_q(q, 1 / q) * d;
      }
      if (norm(gradient) >= 0.35 || neighbours <= 15) continue;
      interior += 1, summed_density += density;
    }
    summed_density /= interior, interior /= static_cast<double>(s.size());
  }
};

TEST(Diagnosis, CountsDensityAsTheSumOverAllPairsDoes) {
  for (const char* impactor : {"{}", R"({"material": {"rho0_kg_per_m3": 1350}})"}) {
    const Scene scene = test::small_scene({{"impactor", nlohmann::json::parse(impactor)},
                                           {"numerics", {{"particles_per_target", 1000}}}});
    io::Snapshot s{scene, initial::make_impact(scene), {}, {}, {}};
    // The impactor comes as near as the sum of the radii, so that both see each other.
    std::array<Vec3, 2> centre;
    std::array<double, 2> count{};
    for (std::size_t i = 0; i < s.state.size(); ++i)
      centre[s.state.body[i]] += s.state.x[i], count[s.state.body[i]] += 1;
    const Vec3 apart = centre[1] / count[1] - centre[0] / count[0];
    for (std::size_t i = 0; i < s.state.size(); ++i)
      if (s.state.body[i] == 1) s.state.x[i] -= (1 - 1 / scene.impact.separation) * apart;
    const BruteForce wanted(scene, s.state);
    const Diagnosis d = diagnose(s);
    EXPECT_NEAR(d.interior, wanted.interior, 1.1 / static_cast<double>(s.state.size())) << impactor;
    EXPECT_NEAR(d.summed_density / wanted.summed_density, 1, 1e-3) << impactor;
  }
}

TEST(Diagnosis, OfARestingBodyIsItsPressureAndItsDensity) {
  const Scene scene = test::small_scene({{"numerics", {{"particles_per_target", 1000}}}});
  const Diagnosis d = diagnose(body(scene, [](const Vec3&) { return Vec3{}; }));
  // Mean pressure of a uniform sphere: two fifths of the central one, 2.55 Pa; the free surface
  // adds a part of order h/R.
  EXPECT_NEAR(d.eos_pressure / (0.4 * central_pressure({50, 2700})), 1, 0.12);
  EXPECT_EQ(d.viscous_pressure, 0);
  EXPECT_LT(d.pressureless, 0.1);
  EXPECT_GT(d.interior, 0.4);
  EXPECT_NEAR(d.summed_density / d.density, 1, 0.03);  // a glass is even to a few per cent
  EXPECT_LT(d.density_error, 0.06);
}

TEST(Diagnosis, SeesThatMonaghansViscosityPressesInShearAndTheShearFreeOneDoesNot) {
  // Uniform shear of 1e-3/s: no compression, and no pressure that the equations know of.
  const auto shear = [](const Vec3& x) { return Vec3{1e-3 * x.y, 0, 0}; };
  const nlohmann::json size = {{"numerics",
                                {{"particles_per_target", 1000},
                                 {"viscosity_particles", 0},
                                 {"viscosity_alpha", 1},
                                 {"viscosity_beta", 2}}}};
  nlohmann::json other = size;
  other["numerics"]["scheme"] = "shear-free";
  const double monaghan = diagnose(body(test::small_scene(size), shear)).viscous_pressure;
  const double shear_free = diagnose(body(test::small_scene(other), shear)).viscous_pressure;
  EXPECT_GT(monaghan, 1);  // Pa: more than gravity's mean pressure
  EXPECT_LT(shear_free, 0.02 * monaghan);
}

TEST(Diagnosis, SeesADensityThatHasDrifted) {
  const Scene scene = test::small_scene({{"numerics", {{"particles_per_target", 1000}}}});
  io::Snapshot s = body(scene, [](const Vec3&) { return Vec3{}; });
  for (double& rho : s.state.rho) rho *= 0.8;
  const Diagnosis d = diagnose(s);
  EXPECT_NEAR(d.density_error, 0.2, 0.05);
  EXPECT_EQ(d.pressureless, 1);
}

TEST(Diagnosis, OfMatterThatASolverRefusesIsFoundAllTheSame) {
  // A layer of particles in one plane: no gradient across it, which stops a step.
  const Scene scene = test::small_scene({{"numerics", {{"particles_per_target", 1000}}}});
  io::Snapshot s = body(scene, [](const Vec3&) { return Vec3{}; });
  const double apart = 0.5 * s.state.h;
  for (std::size_t i = 0; i < s.state.size(); ++i)
    s.state.x[i] = {apart * static_cast<double>(i % 32), apart * static_cast<double>(i / 32), 0};
  EXPECT_THROW(Solver(scene, s.state), NumericalError);
  EXPECT_EQ(diagnose(s).viscous_pressure, 0);
}

}  // namespace
}  // namespace eerie::step
