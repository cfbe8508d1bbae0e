#pragma once

#include <variant>
#include <vector>

#include "solver/base/simd.hpp"
#include "solver/sph/kernel.hpp"
#include "solver/sph/pair_rows.hpp"

namespace eerie {

/// Sums over the neighbours j of one particle i, with x_ij = x_i - x_j, v_ij = v_i - v_j.
struct NeighbourSums {
  SymTensor C;      ///< -sum V_j grad_i W (x) x_ij: the identity inside a uniform body
  Mat3 G;           ///< -sum V_j v_ij (x) grad_i W: the uncorrected velocity gradient, 1/s
  Vec3 force;       ///< sum V_j (T_i + T_j - q_ij 1) . grad_i W: rho_i dv_i/dt, Pa/m
  double heat = 0;  ///< 1/2 sum V_j q_ij v_ij . grad_i W: rho_i du_i/dt of viscosity, W/m^3
};

struct Viscosity {
  double alpha, beta;
  static constexpr double epsilon = 0.01;  ///< of h^2, keeps mu finite (Monaghan 1992)
};

/// Terms that few scenes need; each is left out where its flag is off.
struct ExtraTerms {
  bool evolving_h = false;
  bool artificial_stress = false;  ///< q_ij 1 becomes q_ij 1 - (R_i + R_j) f^4, f = W/W(spacing)
  double spacing = 0;              ///< of particles at rest, m
};

/// The neighbour sweep of a step, for one floating-point type and one kernel: all sums in one
/// visit of each pair. `extended` scenes have heat and ExtraTerms; others pay nothing for them.
/// Each sum is made by one thread in list order; `finish(i, sums)` runs right after it, on the same
/// thread.
template <class Real, class Kernel, bool extended_ = false>
class PairSums {
 public:
  static constexpr bool extended = extended_;
  using Row = PairRow<Real, extended>;
  PairRows<Real, extended> rows;

  PairSums(double h, Viscosity viscosity, ExtraTerms extra = {})
      : h_(h),
        viscosity_(viscosity),
        extra_(extra),
        inverse_w_spacing_(extra.spacing > 0 ? 1 / Kernel::w(extra.spacing / h) : 0) {}

  template <class Finish>
  void sweep(const NeighbourList& lists, std::size_t particles, Finish&& finish) const {
#pragma omp parallel
    {
      std::vector<Row> local;
#pragma omp for schedule(dynamic, 2)
      for (std::size_t b = 0; b < lists.buckets(); ++b) {
        rows.gather(b, lists, local);
        const std::size_t first = b * bucket_size, n = std::min(bucket_size, particles - first);
        for (std::size_t k = 0; k < n; ++k) finish(first + k, sums(local.data(), k, lists[b]));
      }
    }
  }

 private:
  using P = Pack<Real>;
  static Real real(double value) { return static_cast<Real>(value); }

  /// 1/r, finite at r = 0.
  P inverse_distance(P r2) const {
    return inverse_sqrt(P(r2 + real(1e-12) * static_cast<Real>(h_ * h_)));
  }
  /// (dW/dr)/r without its normalisation, for the scene's smoothing length.
  P gradient_factor(P r2, P inverse_r) const {
    return Kernel::dw_over_q(P(r2 * inverse_r * real(1 / h_)), P(inverse_r * real(h_)));
  }
  /// The mean of those of two smoothing lengths, normalised as for the scene's.
  P mean_gradient_factor(P r2, P inverse_r, const Row& me, P inverse_h, P weight) const {
    const P r = r2 * inverse_r, mine = P{} + me.inverse_h;
    const P a = me.weight * Kernel::dw_over_q(P(r * mine), P(inverse_r * inverse(mine)));
    const P b = weight * Kernel::dw_over_q(P(r * inverse_h), P(inverse_r * inverse(inverse_h)));
    return real(0.5) * (a + b);
  }
  double gradient_normalisation() const { return Kernel::normalisation / (h_ * h_ * h_ * h_ * h_); }

  NeighbourSums sums(const Row* local, std::size_t k, const BucketList& list) const {
    const Row& me = local[k];
    const Real h = static_cast<Real>(h_), beta = static_cast<Real>(viscosity_.beta);
    const Real half_alpha = static_cast<Real>(viscosity_.alpha / 2);
    const Real soft = static_cast<Real>(Viscosity::epsilon * h_ * h_);
    P cxx{}, cyy{}, czz{}, cxy{}, cxz{}, cyz{};
    P gxx{}, gxy{}, gxz{}, gyx{}, gyy{}, gyz{}, gzx{}, gzy{}, gzz{};
    P wx_sum{}, wy_sum{}, wz_sum{}, fx{}, fy{}, fz{}, heat{};
    for (std::uint32_t l = list.begin[k]; l < list.begin[k + 1]; l += lanes<Real>) {
      const auto block = [&](int b) __attribute__((always_inline)) {
        return load_transposed<Row::stride>(&local->x, &list.index[l], b);
      };
      const auto [x, y, z, V] = block(0);
      const P dx = me.x - x, dy = me.y - y, dz = me.z - z, r2 = dx * dx + dy * dy + dz * dz;
      const P inverse_r = inverse_distance(r2);
      P factor, h_ij = P{} + h;
      if constexpr (extended) {
        if (extra_.evolving_h) {
          const auto [r4, r5, inverse_h, weight] = block(6);
          factor = mean_gradient_factor(r2, inverse_r, me, inverse_h, weight);
          h_ij = real(2) * inverse(P(me.inverse_h + inverse_h));
        } else {
          factor = gradient_factor(r2, inverse_r);
        }
      } else {
        factor = gradient_factor(r2, inverse_r);
      }
      const P w = V * factor, wx = w * dx, wy = w * dy, wz = w * dz;
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
      const P mu = h_ij * approach * rho_sum * both, rho_h = 2 * me.rho * rho * distance2 * both;
      const P q = rho_h * mu * (half_alpha * (me.c + c) + beta * mu);

      const auto [t0, t1, t2, t3] = block(2);
      const auto [t4, t5, t6, t7] = block(3);
      wx_sum += wx, wy_sum += wy, wz_sum += wz;
      fx += (t0 - q) * wx + t1 * wy + t2 * wz;
      fy += t3 * wx + (t4 - q) * wy + t5 * wz;
      fz += t6 * wx + t7 * wy + (t8 - q) * wz;

      if constexpr (extended) {
        heat -= q * w * approach;  // v_ij . x_ij is -approach
        if (extra_.artificial_stress) {
          const auto [r0, r1, r2_, r3] = block(5);
          const auto [r4, r5, inverse_h, weight] = block(6);
          const P f = Kernel::w(P(r2 * inverse_r * real(1 / h_))) * real(inverse_w_spacing_);
          const P f4 = f * f * f * f, ax = f4 * wx, ay = f4 * wy, az = f4 * wz;
          const P sxx = me.R[0] + r0, syy = me.R[1] + r1, szz = me.R[2] + r2_;
          const P sxy = me.R[3] + r3, sxz = me.R[4] + r4, syz = me.R[5] + r5;
          const P px = sxx * ax + sxy * ay + sxz * az, py = sxy * ax + syy * ay + syz * az,
                  pz = sxz * ax + syz * ay + szz * az;
          fx += px, fy += py, fz += pz;
          heat -= px * ux + py * uy + pz * uz;
        }
      }
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
    NeighbourSums sums{{d[0], d[1], d[2], d[3], d[4], d[5]},
                       {{{d[6], d[7], d[8]}, {d[9], d[10], d[11]}, {d[12], d[13], d[14]}}},
                       n * force};
    if constexpr (extended) sums.heat = n / 2 * lane_sum(heat);
    return sums;
  }

  static double lane_sum(P x) {
    double sum = 0;
    for (int l = 0; l < lanes<Real>; ++l) sum += static_cast<double>(x[l]);
    return sum;
  }

  double h_;
  Viscosity viscosity_;
  ExtraTerms extra_;
  double inverse_w_spacing_;
};

}  // namespace eerie
