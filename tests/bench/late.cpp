// What a lower sound speed would save once velocities are low: goes on from a snapshot with softer
// moduli, pressures kept, and compares with going on as before.
// Usage: eerie_late SNAPSHOT DURATION_S, one line of CSV for each sound speed.

#include <fmt/format.h>
#include <omp.h>

#include <cmath>
#include <ctime>

#include "analysis/remnants/analysis.hpp"
#include "solver/io/snapshot.hpp"
#include "solver/material/tillotson.hpp"
#include "solver/step/solver.hpp"

namespace eerie {
namespace {
using namespace remnants;
using namespace material;
using namespace particles;
using namespace step;
using namespace io;

/// The scene with moduli times `factor`: sound speeds times its root.
Scene softened(Scene scene, double factor) {
  scene.material.tillotson.A_Pa *= factor;
  scene.material.tillotson.B_Pa *= factor;
  scene.material.shear_modulus_Pa *= factor;
  return scene;
}

/// Densities at which the softer material has the same pressures; what has none stays.
particles::State with_pressures_kept(State state, const std::vector<double>& pressure,
                                     const Scene& softer) {
  const Tillotson eos(softer.material);
  for (std::size_t i = 0; i < state.size(); ++i)
    if (pressure[i] > 0) state.rho[i] = eos.density_at(pressure[i]);
  return state;
}

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void go_on(const Snapshot& from, double duration, double factor) {
  const Scene scene = softened(from.scene, factor);
  const double start = processor_seconds(), end = from.state.time + duration;
  Solver solver(scene, with_pressures_kept(from.state, from.pressure, scene));
  while (solver.state().time < end * (1 - 1e-12)) solver.cycle(end);
  const double spent = processor_seconds() - start;
  const Analysis a = analyse({scene, solver.state(), solver.pressure(), {}, {}});
  const Remnant& largest = a.remnants.front();
  fmt::print("{},{},{:.0f},{:.0f},{:.3g},{:.3g},{},{:.4f},{:.4f},{:.4f},{:.3f}\n",
             scene.impact.v_imp_cm_per_s, scene.impact.theta_imp_deg, from.state.time, end,
             std::sqrt(factor), spent, name(a.outcome), largest.mass_over_total,
             largest.shape.b_over_a(), largest.shape.c_over_a(),
             largest.spin_period.value_or(0) / 3600);
  std::fflush(stdout);
}

}  // namespace
}  // namespace eerie

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: eerie_late SNAPSHOT DURATION_S\n");
    return 2;
  }
  omp_set_num_threads(1);
  const eerie::io::Snapshot from = eerie::io::read_snapshot(argv[1]);
  fmt::print(
      "v_imp_cm_per_s,theta_imp_deg,from_s,to_s,sound_speed_factor,core_s,class,m_1_over_m_total,"
      "b_over_a,c_over_a,period_h\n");
  for (const double factor : {1.0, 0.25, 1.0 / 16}) eerie::go_on(from, std::stod(argv[2]), factor);
  return 0;
}
