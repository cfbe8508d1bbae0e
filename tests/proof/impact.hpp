#pragma once

#include <functional>

#include "analysis/remnants/analysis.hpp"
#include "solver/step/solver.hpp"
#include "solver/step/totals.hpp"

namespace eerie::proof {

/// The reference impact (q 1, phi_d 40 deg, theta 15 deg, 20 cm/s) with few particles and
/// `changes` on top (a JSON merge patch).
Scene impact_scene(int particles_per_target, const nlohmann::json& changes);

/// What came of an impact.
struct ImpactEnd {
  remnants::Analysis analysis;
  step::Totals first, last;
  double angular_momentum_drift = 0,
         energy_drift = 0;  ///< over |L| and kinetic energy at the start
  double steps = 0, particle_steps = 0, list_builds = 0, cpu_seconds = 0;
  bool failed = false;
  std::string failure;  ///< kind of the numerical error

  const remnants::Remnant& largest() const { return analysis.remnants.at(0); }
};

/// Runs `scene` to `end_s`; `each` sees the solver after every row of `rows` equal intervals.
/// A numerical error is a result here: it is kept and the run ends.
ImpactEnd followed(const Scene& scene, double end_s, int rows = 0,
                   const std::function<void(const step::Solver&)>& each = {});

}  // namespace eerie::proof
