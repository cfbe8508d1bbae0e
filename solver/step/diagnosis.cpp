#include "solver/step/diagnosis.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "solver/sph/kernel.hpp"
#include "solver/step/solver.hpp"
#include "solver/step/surroundings.hpp"

namespace eerie::step {

namespace {

/// A particle is inside where the sum of its kernel gradients, zero in a uniform medium, is below
/// this part of 1/h (0.7 on a flat surface), and where it has a fair number of neighbours.
constexpr double evenness = 0.35, fewest_neighbours = 15;

struct Arrangement {
  double density;  ///< sum_j m_j W_ij, kg/m^3
  bool inside;
};

template <class Kernel>
Arrangement arrangement(const Surroundings<Kernel>& seen) {
  Pack<float> sum{}, neighbours{}, gx{}, gy{}, gz{};
  seen.visit_packs([&](std::size_t first) {
    const auto [dx, dy, dz] = seen.offsets(first);
    const Pack<float> r2 = dx * dx + dy * dy + dz * dz + 1e-12f;  // 1/r is finite
    const Pack<float> per_r = inverse_sqrt(r2), r = r2 * per_r;
    const Pack<float> slope = seen.weighed(first, Kernel::dw_over_q(r, per_r));
    sum += seen.weighed(first, Kernel::w(r));
    neighbours += r2 < 4 ? splat(1.f) : splat(0.f);  // itself is one of them
    gx += slope * dx, gy += slope * dy, gz += slope * dz;
  });
  const double unevenness =
      seen.per_volume / seen.rho0 * norm(Vec3{total(gx), total(gy), total(gz)});
  return {seen.per_volume * total(sum),
          unevenness < evenness && total(neighbours) > fewest_neighbours + 1};
}

/// Of every particle, by plain sums over volumes at rest and in the units of its own body.
template <class Kernel>
std::vector<Arrangement> arrangements(const Solver& solver, const std::array<double, 2>& size) {
  const particles::State& s = solver.state();
  std::vector<Arrangement> found(s.size());
#pragma omp parallel
  {
    Around around;
#pragma omp for schedule(dynamic, 8)
    for (std::size_t b = 0; b < solver.lists().buckets(); ++b) {
      const std::size_t begin = b * tree::bucket_size;
      around.fill(solver.lists(), b, s, solver.materials());
      for (std::size_t k = 0; k < tree::bucket_size && begin + k < s.size(); ++k) {
        const double h = s.h * size[s.body[begin + k]];
        found[begin + k] =
            arrangement(Surroundings<Kernel>(around, begin, k, s, solver.materials(), h));
      }
    }
  }
  return found;
}

}  // namespace

Diagnosis diagnose(const io::Snapshot& snapshot) {
  // A solver whose friction feels viscosity has summed what viscosity carries.
  Scene scene = snapshot.scene;
  scene.material.drucker_prager.pressure = "total";
  scene.numerics.list_skin = 0;
  const Solver solver = Solver::for_sums(scene, snapshot.state);
  const particles::State& s = solver.state();
  const std::vector<Arrangement> arrangement = std::visit(
      [&](auto kernel) { return arrangements<decltype(kernel)>(solver, particle_sizes(scene)); },
      sph::make_kernel(scene.numerics.kernel));
  Diagnosis d;
  double volume = 0, inside = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const double V = s.mass / s.rho[i], p = solver.pressure()[i];
    volume += V;
    d.eos_pressure += V * p;
    d.viscous_pressure += V * double{solver.rates().viscous_pressure[i]};
    if (p <= 0) d.pressureless += 1;
    if (!arrangement[i].inside) continue;
    inside += 1;
    d.density += s.rho[i];
    d.summed_density += arrangement[i].density;
    const double error = s.rho[i] / arrangement[i].density - 1;
    d.density_error += error * error;
  }
  const auto n = static_cast<double>(s.size());
  d.eos_pressure /= volume, d.viscous_pressure /= volume;
  d.pressureless /= n, d.interior = inside / n;
  if (inside > 0) {
    d.density /= inside, d.summed_density /= inside;
    d.density_error = std::sqrt(d.density_error / inside);
  }
  return d;
}

}  // namespace eerie::step
