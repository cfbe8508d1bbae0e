#pragma once

#include <variant>
#include <vector>

#include "solver/base/simd.hpp"
#include "solver/sph/kernel.hpp"
#include "solver/sph/pair_rows.hpp"

namespace eerie {

/// Sums over the neighbours j of one particle i, with x_ij = x_i - x_j, v_ij = v_i - v_j.
struct NeighbourSums {
  SymTensor C;  ///< -sum V_j grad_i W (x) x_ij: the identity inside a uniform body
  Mat3 G;       ///< -sum V_j v_ij (x) grad_i W: the uncorrected velocity gradient, 1/s
  Vec3 force;   ///< sum V_j (T_i + T_j - q_ij 1) . grad_i W: rho_i dv_i/dt, Pa/m
};

struct Viscosity {
  double alpha, beta;
  static constexpr double epsilon = 0.01;  ///< of h^2, keeps mu finite (Monaghan 1992)
};

/// The neighbour sweep of a step, for one floating-point type and one kernel: all sums in one
/// visit of each pair. Each sum is made by one thread in list order; `finish(i, sums)` runs
/// right after it, on the same thread.
template <class Real, class Kernel>
class PairSums {
  using Row = PairRow<Real>;
  using P = Pack<Real>;

 public:
  PairRows<Real> rows;

  PairSums(double h, Viscosity viscosity) : h_(h), viscosity_(viscosity) {}

  template <class Finish>
  void sweep(const NeighbourList& lists, std::size_t particles, Finish&& finish) const {
#pragma omp parallel
    {
      std::vector<Row> local;
#pragma omp for schedule(dynamic, 2)
      for (std::size_t b = 0; b < lists.buckets(); ++b) {
        rows.gather(b, lists[b], local);
        const std::size_t first = b * bucket_size, n = std::min(bucket_size, particles - first);
        for (std::size_t k = 0; k < n; ++k) finish(first + k, sums(local.data(), k, lists[b]));
      }
    }
  }

 private:
  /// (dW/dr)/r without its normalisation, for separation dx.
  P gradient_factor(P r2) const {
    const Real inverse_h = static_cast<Real>(1 / h_);
    const P s = inverse_sqrt(P(r2 + static_cast<Real>(1e-12) * static_cast<Real>(h_ * h_)));
    return Kernel::dw_over_q(P(r2 * s * inverse_h), P(s * static_cast<Real>(h_)));
  }
  double gradient_normalisation() const { return Kernel::normalisation / (h_ * h_ * h_ * h_ * h_); }

  NeighbourSums sums(const Row* local, std::size_t k, const BucketList& list) const {
    const Row& me = local[k];
    const Real h = static_cast<Real>(h_), beta = static_cast<Real>(viscosity_.beta);
    const Real half_alpha = static_cast<Real>(viscosity_.alpha / 2);
    const Real soft = static_cast<Real>(Viscosity::epsilon * h_ * h_);
    P cxx{}, cyy{}, czz{}, cxy{}, cxz{}, cyz{};
    P gxx{}, gxy{}, gxz{}, gyx{}, gyy{}, gyz{}, gzx{}, gzy{}, gzz{};
    P wx_sum{}, wy_sum{}, wz_sum{}, fx{}, fy{}, fz{};
    for (std::uint32_t l = list.begin[k]; l < list.begin[k + 1]; l += lanes<Real>) {
      const auto block = [&](int b) __attribute__((always_inline)) {
        return load_transposed<Row::stride>(&local->x, &list.index[l], b);
      };
      const auto [x, y, z, V] = block(0);
      const P dx = me.x - x, dy = me.y - y, dz = me.z - z, r2 = dx * dx + dy * dy + dz * dz;
      const P w = V * gradient_factor(r2), wx = w * dx, wy = w * dy, wz = w * dz;
      cxx -= wx * dx, cyy -= wy * dy, czz -= wz * dz;
      cxy -= wx * dy, cxz -= wx * dz, cyz -= wy * dz;

      const auto [vx, vy, vz, rho] = block(1);
      const P ux = me.vx - vx, uy = me.vy - vy, uz = me.vz - vz;
      gxx -= ux * wx, gxy -= ux * wy, gxz -= ux * wz;
      gyx -= uy * wx, gyy -= uy * wy, gyz -= uy * wz;
      gzx -= uz * wx, gzy -= uz * wy, gzz -= uz * wz;

      // Monaghan (1992) viscosity as a pair pressure q = rho_h (-alpha c mu + beta mu^2), with
      // rho_h the harmonic mean density; only approaching pairs feel it.
      const auto [t8, c, unused0, unused1] = block(4);
      const P approach = positive_part(P(-(ux * dx + uy * dy + uz * dz)));
      const P distance2 = r2 + soft, rho_sum = me.rho + rho;
      const P both = inverse(P(distance2 * rho_sum));
      const P mu = h * approach * rho_sum * both, rho_h = 2 * me.rho * rho * distance2 * both;
      const P q = rho_h * mu * (half_alpha * (me.c + c) + beta * mu);

      const auto [t0, t1, t2, t3] = block(2);
      const auto [t4, t5, t6, t7] = block(3);
      wx_sum += wx, wy_sum += wy, wz_sum += wz;
      fx += (t0 - q) * wx + t1 * wy + t2 * wz;
      fy += t3 * wx + (t4 - q) * wy + t5 * wz;
      fz += t6 * wx + t7 * wy + (t8 - q) * wz;
    }
    Real s[32];
    const P first[] = {cxx, cyy, czz, cxy, cxz, cyz, gxx, gxy,
                       gxz, gyx, gyy, gyz, gzx, gzy, gzz, wx_sum};
    const P second[] = {wy_sum, wz_sum, fx, fy, fz};
    lane_sums(first, s);
    lane_sums(second, s + 16);
    const auto T = [&](int c) { return me.T[c]; };
    const Real wx = s[15], wy = s[16], wz = s[17];
    const Vec3 force{double(s[18] + T(0) * wx + T(1) * wy + T(2) * wz),
                     double(s[19] + T(3) * wx + T(4) * wy + T(5) * wz),
                     double(s[20] + T(6) * wx + T(7) * wy + T(8) * wz)};
    const double n = gradient_normalisation();
    double d[15];
    for (int c = 0; c < 15; ++c) d[c] = n * static_cast<double>(s[c]);
    return {{d[0], d[1], d[2], d[3], d[4], d[5]},
            {{{d[6], d[7], d[8]}, {d[9], d[10], d[11]}, {d[12], d[13], d[14]}}},
            n * force};
  }

  double h_;
  Viscosity viscosity_;
};

}  // namespace eerie
