#include <algorithm>
#include <cmath>

#include "solver/sph/kernel.hpp"
#include "solver/step/solver.hpp"

// Voids that close without pressure.

namespace eerie {

namespace {

/// sum_j m W_ij of each particle, itself included: its density by arrangement, kg/m^3.
template <class Kernel>
class Arrangement {
 public:
  Arrangement(const State& state, const NeighbourList& lists, std::size_t row_units)
      : state_(state), lists_(lists), row_units_(row_units) {}

  double density(std::size_t b, std::size_t k) const {
    const BucketList& list = lists_[b];
    const Vec3& x = state_.x[b * bucket_size + k];
    double sum = Kernel::w(0.0);
    for (std::uint32_t e = list.begin[k]; e < list.begin[k + 1]; ++e) {
      const std::size_t place = list.index[e] / row_units_;
      if (place >= list.rows.size()) continue;  // padding
      const double q = norm(x - place_of(list, place)) / state_.h;
      if (q > 0) sum += Kernel::w(q);
    }
    return state_.mass * Kernel::normalisation / (state_.h * state_.h * state_.h) * sum;
  }

 private:
  Vec3 place_of(const BucketList& list, std::size_t place) const {
    const Vec3& x = state_.x[list.rows[place]];
    if (list.images.empty() || list.images[place] == 0) return x;
    return lists_.images()[list.images[place] - 1u](x);
  }

  const State& state_;
  const NeighbourList& lists_;
  std::size_t row_units_;
};

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
  const std::size_t row_units =
      scene_.numerics.precision == "double" ? eerie::row_units<double> : eerie::row_units<float>;
  std::visit(
      [&](auto kernel) {
        const Arrangement<decltype(kernel)> arrangement(state_, lists_, row_units);
#pragma omp parallel for schedule(dynamic, 8)
        for (std::size_t b = 0; b < lists_.buckets(); ++b)
          for (std::size_t k = 0, i = b * bucket_size; k < bucket_size && i < state_.size();
               ++k, ++i)
            has_room_[i] = arrangement.density(b, k) < full;
      },
      make_kernel(scene_.numerics.kernel));
}

/// Where nothing presses, nothing is compressed: density ends a step at that of reference at most.
void Solver::close_voids() {
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < has_room_.size(); ++i)
    if (has_room_[i]) state_.rho[i] = std::min(state_.rho[i], material_.reference_density);
}

}  // namespace eerie
