#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "solver/base/constants.hpp"
#include "tests/proof/impact.hpp"
#include "tests/proof/record.hpp"

// The energy that disperses half of the mass, against numbers that others published.

namespace eerie::proof {
namespace {

/// Q*_RD of equal bodies by Leinhardt & Stewart (2012, eq. 28) for c* = 1, J/kg: the gravitational
/// energy of all mass at 1,000 kg/m^3, per mass.
double energy_scale(const Scene& scene) {
  constexpr double water = 1000;
  const double radius = std::cbrt(2 * target_mass(scene) / (4 * pi / 3 * water));
  return 0.8 * pi * water * newton_G * radius * radius;
}

Scene head_on(const nlohmann::json& material, double specific_energy) {
  // Equal bodies: reduced mass over all mass is 1/4, so Q_R = v^2/8.
  return impact_scene(
      1000,
      {{"impact", {{"theta_imp_deg", 0}, {"v_imp_cm_per_s", 100 * std::sqrt(8 * specific_energy)}}},
       {"material", material}});
}

/// An impact by its energy in units of energy_scale(), and what is left bound of all mass.
struct Left {
  double energy = 0, mass = 0;
};

/// Between two impacts, one on either side of half of the mass.
struct Threshold {
  Left more, less;
  double c_star() const {
    return more.energy + (more.mass - 0.5) / (more.mass - less.mass) * (less.energy - more.energy);
  }
};

/// Head-on impacts. Until there are two about half of the mass, each has the energy at which the
/// one before says that half is left, by the law that M_lr/M = 1 - Q_R/(2 Q*_RD); then one halfway.
Threshold threshold(const nlohmann::json& material) {
  const double scale = energy_scale(head_on(material, 0.01));
  std::optional<Left> more, less;
  double energy = 5;
  for (int k = 0; k < 20 && !(more && less && less->energy < 1.1 * more->energy); ++k) {
    const ImpactEnd end = followed(head_on(material, energy * scale), 8000);
    EXPECT_FALSE(end.failed) << end.failure;
    const Left left{energy, end.analysis.m_lr_over_m_total};
    (left.mass > 0.5 ? more : less) = left;
    energy = more && less ? std::sqrt(more->energy * less->energy)
                          : energy * std::clamp(0.55 / (1 - left.mass), 0.6, 1.6);
  }
  return {more.value(), less.value()};
}

TEST(Disruption, TakesThePublishedEnergyWithoutFrictionAndMoreWithIt) {
  Record record("validation", 13, "The energy that disperses half of the mass",
                "Head-on impacts of equal bodies (50 m, 1,000 particles each). Q*_RD leaves half "
                "of the mass bound at 8,000 s; c* is Q*_RD over the gravitational energy of "
                "Leinhardt & Stewart (2012), found between two impacts a tenth in energy apart.");
  const double fluid = threshold({{"rheology", "fluid"}}).c_star();
  record.within("c* without friction", fluid, 1.6, 7,
                "1.9 +- 0.3 for fluid planets to 5 +- 2 for small bodies");
  Figure figure{"disruption",
                "Energy that disperses half of the mass",
                "friction angle (deg)",
                "c* = Q*_RD / (4/5 π ρ₁ G R²)",
                {},
                "set yrange [0:*]"};
  Curve measured{"measured", {0}, {fluid}, "linespoints pt 7"};
  double before = fluid;
  for (const double phi : {20.0, 30.0, 40.0, 50.0}) {
    const double rubble = threshold({{"drucker_prager", {{"phi_d_deg", phi}}}}).c_star();
    record.within(fmt::format("c*, {:g} deg, over that of less friction", phi), rubble / before, 1,
                  3, "friction dissipates (Jutzi 2015)");
    measured.x.push_back(phi), measured.y.push_back(rubble);
    before = rubble;
  }
  record.within("c*, 40 deg, over that without friction", measured.y[3] / fluid, 1.6, 6.3,
                "half an order of magnitude (Ballouz et al. 2015), within a factor of two");
  figure.curves = {measured};
  record.figure(figure);
}

}  // namespace
}  // namespace eerie::proof
