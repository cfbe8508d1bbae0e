#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/proof/impact.hpp"
#include "tests/proof/record.hpp"

namespace eerie::proof {
namespace {

TEST(ReferenceImpact, ConservesWhatItMust) {
  Record record("validation", 20, "Conservation over the reference impact",
                "The reference impact with 1,000 particles per target and the energy equation "
                "integrated. Energies in units of the kinetic energy at the start; the potential "
                "energy counts from its start.");
  const Scene scene = impact_scene(1000, {{"material", {{"energy", "integrated"}}}});
  Curve kinetic{"kinetic", {}, {}}, potential{"potential", {}, {}}, viscous{"viscous heat", {}, {}},
      friction{"friction heat", {}, {}}, total{"total - start", {}, {}};
  Curve energy{"energy / K", {}, {}}, momentum{"momentum / (M v)", {}, {}},
      angular{"angular momentum / L", {}, {}};
  step::Totals first;
  double worst_energy = 0, worst_angular = 0, worst_momentum = 0, worst_mass = 0;
  const ImpactEnd end = followed(scene, 30000, 150, [&](const step::Solver& solver) {
    const step::Totals now = step::totals(scene, solver.state());
    if (first.mass == 0) first = step::totals(scene, solver.state());
    const double K = first.kinetic_energy, t = solver.state().time;
    const auto add = [t](Curve& curve, double y) { curve.x.push_back(t), curve.y.push_back(y); };
    add(kinetic, now.kinetic_energy / K);
    add(potential, (now.potential_energy - first.potential_energy) / K);
    add(viscous, now.viscous_heat / K);
    add(friction, now.friction_heat / K);
    add(total, (now.energy() - first.energy()) / K);
    add(energy, std::abs(now.energy() - first.energy()) / K + 1e-12);
    add(momentum, norm(now.momentum) / (now.mass * 0.2) + 1e-12);
    add(angular,
        norm(now.angular_momentum - first.angular_momentum) / norm(first.angular_momentum) + 1e-12);
    worst_energy = std::max(worst_energy, energy.y.back());
    worst_momentum = std::max(worst_momentum, momentum.y.back());
    worst_angular = std::max(worst_angular, angular.y.back());
    worst_mass = std::max(worst_mass, std::abs(now.mass - first.mass));
  });
  ASSERT_FALSE(end.failed);
  record.within("mass, largest change", worst_mass, 0, 0, "particles keep their mass");
  record.within("momentum, largest, over M v_imp", worst_momentum, 0, 1e-4,
                "pair forces are opposite; the tree's are to 1e-4 of g");
  record.within("angular momentum, largest change over L", worst_angular, 0, 1e-3,
                "dual force with the correction of the step before, and the tree");
  record.within("energy, largest change over kinetic energy", worst_energy, 0, 2e-3,
                "every term has its partner; error of the time step and of the tree");
  const step::Totals& last = end.last;
  record.within("heat of viscosity and friction over internal energy",
                (last.viscous_heat + last.friction_heat) / last.internal_energy, 0.95, 1.05,
                "the rest is elastic: at most 2 % of the kinetic energy");
  record.noted("heat by viscosity over heat by friction", last.viscous_heat / last.friction_heat,
               "below 1",
               "in rubble friction should do the work; viscosity carries what no "
               "pressure does, more so at low resolution");
  record.figure({"energy-budget",
                 "Where the energy goes",
                 "time (s)",
                 "energy / initial kinetic",
                 {kinetic, potential, viscous, friction, total},
                 ""});
  record.figure({"conservation",
                 "Errors of what is conserved",
                 "time (s)",
                 "relative error",
                 {energy, momentum, angular},
                 "set logscale y; set format y '10^{%T}'; set yrange [1e-10:1e-2]"});
}

}  // namespace
}  // namespace eerie::proof
