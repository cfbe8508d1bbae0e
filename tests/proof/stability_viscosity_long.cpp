#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "solver/base/bodies/sphere.hpp"
#include "solver/initial/bodies.hpp"
#include "solver/step/late.hpp"
#include "tests/proof/impact.hpp"
#include "tests/proof/record.hpp"
#include "tests/proof/resting_body.hpp"

namespace eerie::proof {
namespace {

constexpr particles::Softening slow_flow{0.125, false};

/// As thick for its particles as 50,000 of them are: a stage allows a fifth of the step that motion
/// does.
Scene thick(int stages) {
  return impact_scene(500,
                      {{"numerics", {{"viscosity_particles", 500}, {"viscous_stages", stages}}},
                       {"impact", {{"separation", 1.3}}}});
}

step::Solver softened(const Scene& scene, const step::Solver& solver) {
  return {scene, step::with_softening(solver.state(), solver.pressure(), scene, slow_flow)};
}

/// Largest rms speed of a softened body at rest over the escape speed, after the first fifth.
double restlessness(const Scene& scene, double seconds) {
  const step::Solver stiff(scene, initial::make_body(scene, particles::Body::target));
  step::Solver solver = softened(scene, stiff);
  double fastest = 0;
  while (solver.state().time < seconds) {
    solver.cycle(seconds);
    if (solver.state().time > seconds / 5) fastest = std::max(fastest, rms_speed(solver.state()));
  }
  return fastest / escape_speed({scene.target.radius_m, scene.material.rho0_kg_per_m3});
}

/// The reference impact, soft from `soft_from` s on.
struct SoftEnd {
  double length, drift, steps;
};
SoftEnd soft_impact(const Scene& scene, double soft_from, double end_s) {
  step::Solver stiff(scene, initial::make_impact(scene));
  const step::Totals first = step::totals(scene, stiff.state());
  while (stiff.state().time < soft_from) stiff.cycle(soft_from);
  step::Solver solver = softened(scene, stiff);
  while (solver.state().time < end_s) solver.cycle(end_s);
  const step::Totals last = step::totals(scene, solver.state());
  const remnants::Analysis found =
      remnants::analyse({scene, solver.state(), solver.pressure(), {}, {}});
  return {found.remnants.at(0).shape.a,
          norm(last.angular_momentum - first.angular_momentum) / norm(first.angular_momentum),
          static_cast<double>(solver.state().step - stiff.state().step)};
}

TEST(StagesOfViscosity, LeaveRestAndTheImpactAsTheyAre) {
  Record record(
      "stability", 27, "Stages of viscosity",
      "In slow flow matter is softer at held viscosity, which then shortens steps, and "
      "damps in up to so many stages. 500 particles as thick as 50,000 are, with an "
      "eighth of the speed of sound: a body at rest for 6,000 s, and the reference impact "
      "from 1,500 s to 6,000 s. The default of the ladder is 3.");
  std::vector<std::vector<std::string>> rows;
  double most_moved = 0, restless = 0, drift = 0;
  const SoftEnd one = soft_impact(thick(1), 1500, 6000);
  for (const int stages : {1, 2, 3, 4, 8}) {
    const SoftEnd end = soft_impact(thick(stages), 1500, 6000);
    const double speed = restlessness(thick(stages), 6000);
    most_moved = std::max(most_moved, std::abs(end.length / one.length - 1));
    restless = std::max(restless, speed), drift = std::max(drift, end.drift);
    rows.push_back({std::to_string(stages), fmt::format("{:.2f}", end.steps / one.steps),
                    fmt::format("{:.1f}", end.length), fmt::format("{:.1e}", end.drift),
                    fmt::format("{:.1e}", speed)});
  }
  record.table({"stages at most", "steps", "length, m", "drift of L", "rms speed at rest / escape"},
               rows);
  record.within("largest change of length", most_moved, 0, 0.05, "below the scatter of seeds");
  record.within("largest drift of L", drift, 0, 2e-3, "below what moves a shape");
  record.within("largest rms speed at rest / escape speed", restless, 0, 1e-3,
                "bodies count as settled below 1e-3");
}

}  // namespace
}  // namespace eerie::proof
