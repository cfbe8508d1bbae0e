#include <gtest/gtest.h>

#include "solver/base/bodies/sphere.hpp"
#include "solver/initial/bodies.hpp"
#include "solver/step/diagnosis.hpp"
#include "tests/support/scenes.hpp"

namespace eerie::step {
namespace {

io::Snapshot body(const Scene& scene, const std::function<Vec3(const Vec3&)>& velocity) {
  io::Snapshot s{scene, initial::make_body(scene, particles::Body::target), {}, {}, {}};
  for (std::size_t i = 0; i < s.state.size(); ++i) s.state.v[i] = velocity(s.state.x[i]);
  return s;
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

}  // namespace
}  // namespace eerie::step
