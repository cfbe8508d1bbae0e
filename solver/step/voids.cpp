#include <algorithm>

#include "solver/sph/flat_surface.hpp"
#include "solver/sph/kernel.hpp"
#include "solver/step/solver.hpp"
#include "solver/step/surroundings.hpp"

// Voids that close without pressure.

namespace eerie::step {

namespace {

/// Cosine of the angle to the outward normal within which nothing lies beyond a free surface.
constexpr double cos_of_sight = 0.7071;
/// What a ball of four smoothing lengths, 500 particles, has less than a flat surface of the same
/// first moment: s^2/2R of the layer above, 0.04 of the reference density.
constexpr double convexity = 0.95;

/// Sums over the lanes come later: most particles lie deep inside, where density is enough.
struct Moments {
  double per_volume;
  Pack<float> sum{}, mx{}, my{}, mz{};

  /// sum_j m W_ij, kg/m^3
  double density() const { return per_volume * total(sum); }
  /// sum_j m W_ij x_ij/h, kg/m^3
  Vec3 outward() const { return per_volume * Vec3{total(mx), total(my), total(mz)}; }
};

template <class Kernel>
Moments moments(const Surroundings<Kernel>& seen) {
  Moments m{seen.per_volume};
  seen.visit_packs([&](std::size_t first) {
    const auto [dx, dy, dz] = seen.offsets(first);
    const Pack<float> r2 = dx * dx + dy * dy + dz * dz + 1e-12f;  // 1/r is finite
    const Pack<float> w = seen.weighed(first, Kernel::w(Pack<float>(r2 * inverse_sqrt(r2))));
    m.sum += w;
    m.mx -= w * dx, m.my -= w * dy, m.mz -= w * dz;
  });
  return m;
}

/// Whether something in reach of the kernel lies towards `normal`, a unit vector.
template <class Kernel>
bool faces_something(const Surroundings<Kernel>& seen, const Vec3& normal) {
  const auto nx = static_cast<float>(normal.x), ny = static_cast<float>(normal.y),
             nz = static_cast<float>(normal.z);
  const float cos2 = static_cast<float>(cos_of_sight * cos_of_sight);
  Pack<float> found{};  // summed over all: leaving at the first one would take lanes apart
  seen.visit_packs([&](std::size_t first) {
    const auto [dx, dy, dz] = seen.offsets(first);
    const Pack<float> r2 = dx * dx + dy * dy + dz * dz, ahead = nx * dx + ny * dy + nz * dz;
    found += (ahead > 0) & (r2 < 4) & (ahead * ahead > cos2 * r2) ? splat(1.f) : splat(0.f);
  });
  return total(found) > 0;
}

}  // namespace

/// The continuity equation compresses particles of two surfaces as soon as their kernels overlap,
/// which holds the surfaces 1.7 spacings apart: bodies act as if they were larger, and rubble that
/// was sheared keeps gaps. So nothing presses where the arrangement, counted, has room for more;
/// with numerics.voids "gaps" only where that is between two surfaces: one that is as dense as a
/// flat one and beyond which nothing lies keeps its pressure. Looked at once in a cycle:
/// arrangements hardly change in one.
void Solver::find_voids() {
  if (!sees_voids_) return;
  const StageTimer timer(stages_, Stage::material);
  const double part = scene_.numerics.void_density;
  const bool gaps_only = scene_.numerics.voids == "gaps";
  is_void_.resize(state_.size());
  std::visit(
      [&](auto kernel) {
        using Kernel = decltype(kernel);
        const auto has_room = [&](const Surroundings<Kernel>& seen) {
          const Moments around = moments(seen);
          const double rho0 = seen.rho0, density = around.density();
          if (density >= part * rho0) return false;
          if (!gaps_only) return true;
          const Vec3 outward = around.outward();
          const double m = norm(outward);
          const bool fits =
              density >= convexity * part * rho0 * sph::flat_density<Kernel>(m / rho0);
          return !fits || m == 0 || faces_something(seen, outward / m);
        };
#pragma omp parallel
        {
          Around around;
#pragma omp for schedule(dynamic, 8)
          for (std::size_t b = 0; b < lists_.buckets(); ++b) {
            const std::size_t begin = b * tree::bucket_size;
            around.fill(lists_, b, state_, materials_);
            for (std::size_t k = 0; k < tree::bucket_size && begin + k < state_.size(); ++k)
              is_void_[begin + k] = has_room(
                  {around, begin, k, state_, materials_, constant_h_[state_.body[begin + k]]});
          }
        }
      },
      sph::make_kernel(scene_.numerics.kernel));
}

/// Where nothing presses, nothing is compressed: density ends a step at that of reference at most.
void Solver::close_voids() {
  if (is_void_.empty()) return;
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < is_void_.size(); ++i)
    if (is_void_[i]) state_.rho[i] = std::min(state_.rho[i], reference_density(i));
}

}  // namespace eerie::step
