#include "solver/step/diagnosis.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "solver/sph/kernel.hpp"
#include "solver/step/solver.hpp"

namespace eerie::step {

namespace {

/// A particle is inside where the sum of its kernel gradients, zero in a uniform medium, is below
/// this part of 1/h (0.7 on a flat surface), and where it has a fair number of neighbours.
constexpr double evenness = 0.35, fewest_neighbours = 15;

struct Arrangement {
  double density;  ///< sum_j m_j W_ij, kg/m^3
  bool inside;
};

/// Of every particle, by plain sums over volumes at rest and in the units of its own body.
template <class Kernel>
std::vector<Arrangement> arrangements(const particles::State& s,
                                      const material::OfBodies& materials,
                                      const std::array<double, 2>& size) {
  tree::KdTree tree(s.size());
  tree.fit(s.x);
  tree::NeighbourList lists(2 * s.h, 0);
  lists.build(tree, s.x);
  std::vector<Arrangement> found(s.size());
#pragma omp parallel for schedule(dynamic, 8)
  for (std::size_t b = 0; b < lists.buckets(); ++b) {
    for (std::size_t k = 0, i = b * tree::bucket_size; k < tree::bucket_size && i < s.size();
         ++k, ++i) {
      const double h = s.h * size[s.body[i]], rho0 = materials.reference_density(s.body[i]);
      const double scale = Kernel::normalisation / cubed(h);
      double density = s.mass * scale * Kernel::w(0.0), neighbours = 0;
      Vec3 gradient;
      lists.visit_listed(b, k, s.x, [&](const Vec3& there, std::size_t j) {
        const Vec3 d = s.x[i] - there;
        const double q = norm(d) / h;
        if (q >= 2 || q == 0) return;
        ++neighbours;
        const double V = s.mass / materials.reference_density(s.body[j]);
        density += rho0 * V * scale * Kernel::w(q);
        gradient += (V * scale * Kernel::dw_over_q(q, 1 / q) / h) * d;
      });
      found[i] = {density, norm(gradient) < evenness && neighbours > fewest_neighbours};
    }
  }
  return found;
}

}  // namespace

Diagnosis diagnose(const io::Snapshot& snapshot) {
  // A solver whose friction feels viscosity has summed what viscosity carries.
  Scene scene = snapshot.scene;
  scene.material.drucker_prager.pressure = "total";
  scene.environment.self_gravity = false;  // sums do not need it, and it costs more than they do
  const Solver solver(scene, snapshot.state);
  const particles::State& s = solver.state();
  const std::vector<Arrangement> arrangement = std::visit(
      [&](auto kernel) {
        return arrangements<decltype(kernel)>(s, solver.materials(), particle_sizes(scene));
      },
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
