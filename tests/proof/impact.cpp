#include "tests/proof/impact.hpp"

#include <ctime>
#include <nlohmann/json.hpp>

#include "solver/base/error.hpp"
#include "solver/initial/bodies.hpp"

namespace eerie::proof {

Scene impact_scene(int particles_per_target, const nlohmann::json& changes) {
  nlohmann::json scene = {{"numerics", {{"particles_per_target", particles_per_target}}}};
  scene.merge_patch(changes);
  return parse_scene(scene);
}

ImpactEnd followed(const Scene& scene, double end_s, int rows,
                   const std::function<void(const step::Solver&)>& each) {
  ImpactEnd end;
  try {
    step::Solver solver(scene, initial::make_impact(scene));
    end.first = step::totals(scene, solver.state());
    const std::clock_t start = std::clock();
    for (int row = 1; row <= std::max(rows, 1); ++row) {
      const double until = end_s * row / std::max(rows, 1);
      while (solver.state().time < until * (1 - 1e-12)) solver.cycle(until);
      if (each) each(solver);
    }
    end.cpu_seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    end.last = step::totals(scene, solver.state());
    end.analysis = remnants::analyse({scene, solver.state(), solver.pressure(), {}, {}});
    end.steps = static_cast<double>(solver.state().step);
    end.particle_steps = end.steps * static_cast<double>(solver.state().size());
    end.list_builds = static_cast<double>(solver.list_builds());
    end.angular_momentum_drift = norm(end.last.angular_momentum - end.first.angular_momentum) /
                                 norm(end.first.angular_momentum);
    end.energy_drift = (end.last.energy() - end.first.energy()) / end.first.kinetic_energy;
  } catch (const NumericalError& error) {
    end.failed = true;
    end.failure = error.kind;
  }
  return end;
}

}  // namespace eerie::proof
