#include <algorithm>
#include <cstring>
#include <vector>

#include "solver/sph/flat_surface.hpp"
#include "solver/sph/kernel.hpp"
#include "solver/step/solver.hpp"
#include "solver/tree/places.hpp"

// Voids that close without pressure.

namespace eerie::step {

namespace {

/// Cosine of the angle to the outward normal within which nothing lies beyond a free surface.
constexpr double cos_of_sight = 0.7071;
/// What a ball of four smoothing lengths, 500 particles, has less than a flat surface of the same
/// first moment: s^2/2R of the layer above, 0.04 of the reference density.
constexpr double convexity = 0.95;

/// What lies around the particles of a bucket. Places are in units of one h for all.
struct Around {
  tree::Places at;
  /// The inverse of the reference density of each, m^3/kg; empty where all have one.
  std::vector<float> per_density;
};

/// How particle k of a bucket is surrounded.
template <class Kernel>
struct Surroundings {
  const Around& around;
  std::size_t k;
  double rho0;        ///< of the particle, kg/m^3
  double per_volume;  ///< m/h^3 and the kernel's normalisation, kg/m^3
  float finer;        ///< units of place over its own h

  /// Calls visit(first) for each pack of which something may lie within the kernel's reach, 2 h.
  template <class Visit>
  void visit_packs(Visit&& visit) const {
    const tree::Places& at = around.at;
    constexpr float reach2 = 4.0001f;  // a little more than 4, for what rounding does to 1/r
    at.visit_packs_near(at.x[k], at.y[k], at.z[k], reach2 / (finer * finer), visit);
  }
  tree::Places::Offsets offsets(std::size_t first) const {
    const tree::Places& at = around.at;
    auto [x, y, z] = at.offsets(first, at.x[k], at.y[k], at.z[k]);
    if (!around.per_density.empty()) x *= finer, y *= finer, z *= finer;
    return {x, y, z};
  }
  /// A particle of other density takes another volume: its kernel in the units of this one.
  Pack<float> weight(std::size_t first, const Pack<float>& r) const {
    const Pack<float> w = Kernel::w(r);
    if (around.per_density.empty()) return w;
    Pack<float> per_density;
    std::memcpy(&per_density, around.per_density.data() + first, sizeof per_density);
    return w * per_density * static_cast<float>(rho0);
  }

  /// Sums over the lanes come later: most particles lie deep inside, where density is enough.
  struct Moments {
    double per_volume;
    Pack<float> sum{}, mx{}, my{}, mz{};

    /// sum_j m W_ij, kg/m^3
    double density() const { return per_volume * total(sum); }
    /// sum_j m W_ij x_ij/h, kg/m^3
    Vec3 outward() const { return per_volume * Vec3{total(mx), total(my), total(mz)}; }
  };
  Moments moments() const {
    Moments m{per_volume};
    visit_packs([&](std::size_t first) {
      const auto [dx, dy, dz] = offsets(first);
      const Pack<float> r2 = dx * dx + dy * dy + dz * dz + 1e-12f;  // 1/r is finite
      const Pack<float> w = weight(first, r2 * inverse_sqrt(r2));
      m.sum += w;
      m.mx -= w * dx, m.my -= w * dy, m.mz -= w * dz;
    });
    return m;
  }
  /// Whether something in reach of the kernel lies towards `normal`, a unit vector.
  bool faces_something(const Vec3& normal) const {
    const auto nx = static_cast<float>(normal.x), ny = static_cast<float>(normal.y),
               nz = static_cast<float>(normal.z);
    const float cos2 = static_cast<float>(cos_of_sight * cos_of_sight);
    Pack<float> seen{};  // summed over all: leaving at the first one would take lanes apart
    visit_packs([&](std::size_t first) {
      const auto [dx, dy, dz] = offsets(first);
      const Pack<float> r2 = dx * dx + dy * dy + dz * dz, ahead = nx * dx + ny * dy + nz * dz;
      seen += (ahead > 0) & (r2 < 4) & (ahead * ahead > cos2 * r2) ? splat(1.f) : splat(0.f);
    });
    return total(seen) > 0;
  }
  static double total(const Pack<float>& pack) {
    double sum = 0;
    for (int l = 0; l < lanes<float>; ++l) sum += double{pack[l]};
    return sum;
  }
};

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
          const auto moments = seen.moments();
          const double rho0 = seen.rho0, density = moments.density();
          if (density >= part * rho0) return false;
          if (!gaps_only) return true;
          const Vec3 outward = moments.outward();
          const double m = norm(outward);
          const bool fits =
              density >= convexity * part * rho0 * sph::flat_density<Kernel>(m / rho0);
          return !fits || m == 0 || seen.faces_something(outward / m);
        };
#pragma omp parallel
        {
          Around around;
#pragma omp for schedule(dynamic, 8)
          for (std::size_t b = 0; b < lists_.buckets(); ++b) {
            const std::size_t begin = b * tree::bucket_size;
            const tree::BucketList& list = lists_[b];
            around.at.fill(list.rows.size(), [&](std::size_t place) {
              const Vec3& x = state_.x[list.rows[place]];
              return (list.as_seen(place, x, lists_.images()) - state_.x[begin]) / state_.h;
            });
            around.per_density.clear();
            if (materials_.has_two_densities())
              for (const std::uint32_t j : list.rows)
                around.per_density.push_back(static_cast<float>(1 / reference_density(j)));
            if (!around.per_density.empty()) around.per_density.resize(around.at.x.size());
            for (std::size_t k = 0; k < tree::bucket_size && begin + k < state_.size(); ++k) {
              const double rho0 = reference_density(begin + k),
                           h = constant_h_[state_.body[begin + k]];
              const double per_volume = state_.mass * Kernel::normalisation / cubed(h);
              is_void_[begin + k] =
                  has_room({around, k, rho0, per_volume, static_cast<float>(state_.h / h)});
            }
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
