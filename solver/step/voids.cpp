#include <algorithm>

#include "solver/base/places.hpp"
#include "solver/sph/kernel.hpp"
#include "solver/step/solver.hpp"

// Voids that close without pressure.

namespace eerie::step {

namespace {

/// sum_j m W_ij over all that is around a bucket, for particle k of it: its density by arrangement,
/// kg/m^3. `around` in units of h.
template <class Kernel>
double arranged_density(const particles::State& s, const Places& around, std::size_t k) {
  Pack<float> sum{};
  for (std::size_t first = 0; first < around.x.size(); first += lanes<float>) {
    const Pack<float> r2 =
        around.distance2(first, around.x[k], around.y[k], around.z[k]) + 1e-12f;  // 1/r is finite
    sum += Kernel::w(Pack<float>(r2 * inverse_sqrt(r2)));
  }
  double w = 0;
  for (int l = 0; l < lanes<float>; ++l) w += double{sum[l]};
  return s.mass * Kernel::normalisation / cubed(s.h) * w;
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
#pragma omp parallel
        {
          Places around;
#pragma omp for schedule(dynamic, 8)
          for (std::size_t b = 0; b < lists_.buckets(); ++b) {
            const std::size_t begin = b * tree::bucket_size;
            around.clear();
            lists_.visit_around(b, state_.x, [&](const Vec3& there) {
              around.push((there - state_.x[begin]) / state_.h);
            });
            around.pad();
            for (std::size_t k = 0; k < tree::bucket_size && begin + k < state_.size(); ++k)
              has_room_[begin + k] = arranged_density<decltype(kernel)>(state_, around, k) < full;
          }
        }
      },
      sph::make_kernel(scene_.numerics.kernel));
}

/// Where nothing presses, nothing is compressed: density ends a step at that of reference at most.
void Solver::close_voids() {
  if (has_room_.empty()) return;
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < has_room_.size(); ++i)
    if (has_room_[i]) state_.rho[i] = std::min(state_.rho[i], material_.reference_density);
}

}  // namespace eerie::step
