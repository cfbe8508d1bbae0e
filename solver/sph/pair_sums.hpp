#pragma once

#include <variant>
#include <vector>

#include "solver/base/simd.hpp"
#include "solver/sph/kernel.hpp"
#include "solver/sph/pair_rows.hpp"

namespace eerie {

/// Raw sums over the neighbours j of one particle i, x_ij = x_i - x_j, v_ij = v_i - v_j.
struct GradientSums {
  SymTensor C;  ///< -sum V_j grad_i W (x) x_ij: the identity inside a uniform body
  Mat3 G;       ///< -sum V_j v_ij (x) grad_i W: the uncorrected velocity gradient, 1/s
};

struct Viscosity {
  double alpha, beta;
  static constexpr double epsilon = 0.01;  ///< of h^2, keeps mu finite (Monaghan 1992)
};

/// The two neighbour sweeps of a step, for one floating-point type and one kernel. Each sum is
/// made by one thread in list order; `finish(i, sums)` runs right after it, on the same thread.
template <class Real, class Kernel>
class PairSums {
 public:
  PairRows<Real> rows;

  PairSums(double h, Viscosity viscosity) : h_(h), viscosity_(viscosity) {}

  template <class Finish>
  void gradients(const NeighbourList& lists, std::size_t particles, Finish&& finish) const {
    sweep(lists, particles, [&](const Row* local, int k, const BucketList& list, std::size_t i) {
      finish(i, gradient_sums(local, k, list));
    });
  }

  /// finish(i, F, V_i) with F = sum V_j (T_i + T_j - q_ij 1) . grad_i W, Pa/m: rho_i dv_i/dt.
  template <class Finish>
  void forces(const NeighbourList& lists, std::size_t particles, Finish&& finish) const {
    sweep(lists, particles, [&](const Row* local, int k, const BucketList& list, std::size_t i) {
      finish(i, force_sum(local, k, list), static_cast<double>(local[k].V));
    });
  }

 private:
  using Row = PairRow<Real>;
  using P = Pack<Real>;

  template <class Visit>
  void sweep(const NeighbourList& lists, std::size_t particles, Visit&& visit) const {
#pragma omp parallel
    {
      std::vector<Row> local;
#pragma omp for schedule(dynamic, 2)
      for (std::size_t b = 0; b < lists.buckets(); ++b) {
        const BucketList& list = lists[b];
        rows.gather(b, list, local);
        const std::size_t first = b * bucket_size, n = std::min(bucket_size, particles - first);
        for (std::size_t k = 0; k < n; ++k)
          visit(local.data(), static_cast<int>(k), list, first + k);
      }
    }
  }

  /// (dW/dr)/r without its normalisation, for separation dx.
  P gradient_factor(P r2) const {
    const Real inverse_h = static_cast<Real>(1 / h_);
    const P s = inverse_sqrt(P(r2 + static_cast<Real>(1e-12) * static_cast<Real>(h_ * h_)));
    return Kernel::dw_over_q(P(r2 * s * inverse_h), P(s * static_cast<Real>(h_)));
  }
  double gradient_normalisation() const { return Kernel::normalisation / (h_ * h_ * h_ * h_ * h_); }

  GradientSums gradient_sums(const Row* local, int k, const BucketList& list) const {
    const Row& me = local[k];
    P cxx{}, cyy{}, czz{}, cxy{}, cxz{}, cyz{};
    P gxx{}, gxy{}, gxz{}, gyx{}, gyy{}, gyz{}, gzx{}, gzy{}, gzz{};
    for (std::uint32_t l = list.begin[static_cast<std::size_t>(k)]; l < list.begin[static_cast<std::size_t>(k) + 1]; l += lanes<Real>) {
      P a[4], b[4];
      load_transposed<Row::stride>(&local->x, &list.index[l], 0, a);
      load_transposed<Row::stride>(&local->x, &list.index[l], 1, b);
      const P dx = me.x - a[0], dy = me.y - a[1], dz = me.z - a[2];
      const P w = -a[3] * gradient_factor(dx * dx + dy * dy + dz * dz);
      const P wx = w * dx, wy = w * dy, wz = w * dz;
      cxx += wx * dx, cyy += wy * dy, czz += wz * dz;
      cxy += wx * dy, cxz += wx * dz, cyz += wy * dz;
      const P ux = me.vx - b[0], uy = me.vy - b[1], uz = me.vz - b[2];
      gxx += ux * wx, gxy += ux * wy, gxz += ux * wz;
      gyx += uy * wx, gyy += uy * wy, gyz += uy * wz;
      gzx += uz * wx, gzy += uz * wy, gzz += uz * wz;
    }
    const double n = gradient_normalisation();
    const auto sum = [n](P p) { return n * static_cast<double>(lane_sum<Real>(p)); };
    return {{sum(cxx), sum(cyy), sum(czz), sum(cxy), sum(cxz), sum(cyz)},
            {{{sum(gxx), sum(gxy), sum(gxz)},
              {sum(gyx), sum(gyy), sum(gyz)},
              {sum(gzx), sum(gzy), sum(gzz)}}}};
  }

  Vec3 force_sum(const Row* local, int k, const BucketList& list) const {
    const Row& me = local[k];
    const Real h = static_cast<Real>(h_), alpha = static_cast<Real>(viscosity_.alpha),
               beta = static_cast<Real>(viscosity_.beta);
    const Real soft = static_cast<Real>(Viscosity::epsilon * h_ * h_);
    P wx_sum{}, wy_sum{}, wz_sum{}, fx{}, fy{}, fz{};
    for (std::uint32_t l = list.begin[static_cast<std::size_t>(k)]; l < list.begin[static_cast<std::size_t>(k) + 1]; l += lanes<Real>) {
      P a[4], b[4], t[4], s[4], r[4];
      load_transposed<Row::stride>(&local->x, &list.index[l], 0, a);
      load_transposed<Row::stride>(&local->x, &list.index[l], 1, b);
      load_transposed<Row::stride>(&local->x, &list.index[l], 2, t);
      load_transposed<Row::stride>(&local->x, &list.index[l], 3, s);
      load_transposed<Row::stride>(&local->x, &list.index[l], 4, r);
      const P dx = me.x - a[0], dy = me.y - a[1], dz = me.z - a[2];
      const P r2 = dx * dx + dy * dy + dz * dz;
      const P w = a[3] * gradient_factor(r2);
      const P wx = w * dx, wy = w * dy, wz = w * dz;
      // Monaghan (1992) viscosity as a pair pressure q = rho_h (-alpha c mu + beta mu^2), with
      // rho_h the harmonic mean density; only approaching pairs feel it.
      const P approach = positive_part(P((b[0] - me.vx) * dx + (b[1] - me.vy) * dy + (b[2] - me.vz) * dz));
      const P mu = h * approach / (r2 + soft);
      const P rho_h = 2 * me.rho * b[3] / (me.rho + b[3]);
      const P q = rho_h * mu * (alpha * static_cast<Real>(0.5) * (me.c + r[1]) + beta * mu);
      wx_sum += wx, wy_sum += wy, wz_sum += wz;
      fx += t[0] * wx + t[1] * wy + t[2] * wz - q * wx;
      fy += t[3] * wx + s[0] * wy + s[1] * wz - q * wy;
      fz += s[2] * wx + s[3] * wy + r[0] * wz - q * wz;
    }
    const auto sum = [](P p) { return static_cast<double>(lane_sum<Real>(p)); };
    const Vec3 grad{sum(wx_sum), sum(wy_sum), sum(wz_sum)}, others{sum(fx), sum(fy), sum(fz)};
    const auto T = [&](int c) { return static_cast<double>(me.T[c]); };
    const Mat3 own{{{T(0), T(1), T(2)}, {T(3), T(4), T(5)}, {T(6), T(7), T(8)}}};
    return gradient_normalisation() * (own * grad + others);
  }

  double h_;
  Viscosity viscosity_;
};

}  // namespace eerie
