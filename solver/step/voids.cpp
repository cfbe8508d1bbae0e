#include <algorithm>
#include <cmath>

#include "solver/sph/kernel.hpp"
#include "solver/step/solver.hpp"

// Voids that close without pressure.

namespace eerie {

namespace {

/// sum_j m W_ij of particle k of a bucket, itself included: its density by arrangement, kg/m^3.
template <class Kernel>
double arranged_density(const State& s, const NeighbourList& lists, std::size_t bucket,
                        std::size_t k) {
  const Vec3& x = s.x[bucket * bucket_size + k];
  double sum = Kernel::w(0.0);
  lists.visit_listed(bucket, k, s.x, [&](const Vec3& there) {
    const double q = norm(x - there) / s.h;
    if (q > 0) sum += Kernel::w(q);
  });
  return s.mass * Kernel::normalisation / (s.h * s.h * s.h) * sum;
}

}  // namespace

/// The continuity equation compresses particles of two surfaces as soon as their kernels overlap,
/// which holds the surfaces 1.7 spacings apart: bodies act as if they were larger, and rubble that
/// was sheared keeps gaps. So nothing presses where the arrangement, counted, has room for more.
/// Looked at once in a cycle: arrangements hardly change in one.
void Solver::find_voids() {
  const double full = scene_.numerics.void_density * material_.reference_density;
  if (full == 0) return;
  const StageTimer timer(stages_, Stage::material);
  has_room_.resize(state_.size());
  std::visit(
      [&](auto kernel) {
#pragma omp parallel for schedule(dynamic, 8)
        for (std::size_t b = 0; b < lists_.buckets(); ++b)
          for (std::size_t k = 0, i = b * bucket_size; k < bucket_size && i < state_.size();
               ++k, ++i)
            has_room_[i] = arranged_density<decltype(kernel)>(state_, lists_, b, k) < full;
      },
      make_kernel(scene_.numerics.kernel));
}

/// Where nothing presses, nothing is compressed: density ends a step at that of reference at most.
void Solver::close_voids() {
  if (has_room_.empty()) return;
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < has_room_.size(); ++i)
    if (has_room_[i]) state_.rho[i] = std::min(state_.rho[i], material_.reference_density);
}

}  // namespace eerie
