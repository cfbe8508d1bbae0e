#pragma once

#include <array>
#include <variant>
#include <vector>

#include "solver/base/simd.hpp"
#include "solver/sph/kernel.hpp"
#include "solver/sph/pair_rows.hpp"

namespace eerie {

/// Sums over the neighbours j of one particle i, with x_ij = x_i - x_j, v_ij = v_i - v_j; of
/// several particles at once where T is a Pack.
template <class T>
struct NeighbourSumsOf {
  SymTensorOf<T> C;  ///< -sum V_j grad_i W (x) x_ij: the identity inside a uniform body
  Mat3Of<T> G;       ///< -sum V_j v_ij (x) grad_i W: the uncorrected velocity gradient, 1/s
  /// sum V_j (T_i + T_j - q_ij 1) . grad_i W: rho_i dv_i/dt, Pa/m
  std::conditional_t<std::is_same_v<T, double>, Vec3, std::array<T, 3>> force{};
  T heat{};  ///< 1/2 sum V_j q_ij v_ij . grad_i W: rho_i du_i/dt of viscosity, W/m^3
};
using NeighbourSums = NeighbourSumsOf<double>;
using PackedSums = NeighbourSumsOf<Pack<double>>;

/// The sums of one particle out of several.
inline NeighbourSums lane(const PackedSums& s, std::size_t l) {
  NeighbourSums one;
  one.C = {s.C.xx[l], s.C.yy[l], s.C.zz[l], s.C.xy[l], s.C.xz[l], s.C.yz[l]};
  for (int k = 0; k < 9; ++k) one.G[k / 3][k % 3] = s.G[k / 3][k % 3][l];
  for (int a = 0; a < 3; ++a) one.force[a] = s.force[a][l];
  one.heat = s.heat[l];
  return one;
}

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
/// Each sum is made by one thread in list order; `finish(i, count, sums)` runs right after them on
/// the same thread, for particles i to i + count - 1: lane l of `sums` belongs to i + l.
template <class Real, class Kernel, bool extended_ = false>
class PairSums {
 public:
  static constexpr bool extended = extended_;
  using Row = PairRow<Real, extended>;
  PairRows<Real, extended> rows;

  /// h: the scene's smoothing length, m; mass: of a particle, kg.
  PairSums(double h, double mass, Viscosity viscosity, ExtraTerms extra = {})
      : rows(h),
        h_(h),
        scaled_mass_(mass / (h * h * h)),
        viscosity_(viscosity),
        extra_(extra),
        inverse_w_spacing_(extra.spacing > 0 ? 1 / Kernel::w(extra.spacing / h) : 0) {}

  template <class Finish>
  void sweep(const NeighbourList& lists, std::size_t particles, Finish&& finish) const {
#pragma omp parallel
    {
      std::vector<Row> local;
      std::vector<Raw> raw(bucket_size);
#pragma omp for schedule(dynamic, 2)
      for (std::size_t b = 0; b < lists.buckets(); ++b) {
        rows.gather(b, lists, local);
        const std::size_t first = b * bucket_size, n = std::min(bucket_size, particles - first);
        for (std::size_t k = 0; k < n; ++k) sum(local.data(), k, lists[b], raw[k]);
        for (std::size_t k = 0; k < n; k += lanes<Real>) {
          std::size_t at = k;
          for (const PackedSums& sums : scaled(raw.data() + k)) {
            if (at < n) finish(first + at, std::min<std::size_t>(n - at, lanes<double>), sums);
            at += lanes<double>;
          }
        }
      }
    }
  }

 private:
  using P = Pack<Real>;
  static Real real(double value) { return static_cast<Real>(value); }

  /// The sums of one particle without their normalisation: C, G, kernel gradients, force, heat.
  struct alignas(vector_bytes) Raw {
    static constexpr int C = 0, G = 6, w = 15, force = 18, heat = 21, count = 22, stride = 32;
    Real s[stride];
  };

  /// (dW/dr)/r without its normalisation, for the scene's smoothing length.
  P gradient_factor(P r2, P inverse_r) const {
    return Kernel::dw_over_q(P(r2 * inverse_r), inverse_r);
  }
  /// The mean of those of two smoothing lengths, normalised as for the scene's.
  P mean_gradient_factor(P r2, P inverse_r, const Row& me, P inverse_h, P weight) const {
    const P r = r2 * inverse_r, mine = P{} + me.inverse_h;
    const P a = me.weight * Kernel::dw_over_q(P(r * mine), P(inverse_r * inverse(mine)));
    const P b = weight * Kernel::dw_over_q(P(r * inverse_h), P(inverse_r * inverse(inverse_h)));
    return real(0.5) * (a + b);
  }

  void sum(const Row* local, std::size_t k, const BucketList& list, Raw& out) const {
    const Row& me = local[k];
    const Real half_alpha = real(viscosity_.alpha / 2), beta = real(viscosity_.beta);
    const Real two_m = real(2 * scaled_mass_);
    P cxx{}, cyy{}, czz{}, cxy{}, cxz{}, cyz{};
    P gxx{}, gxy{}, gxz{}, gyx{}, gyy{}, gyz{}, gzx{}, gzy{}, gzz{};
    P wx_sum{}, wy_sum{}, wz_sum{}, fx{}, fy{}, fz{}, heat{};
    for (std::uint32_t l = list.begin[k]; l < list.begin[k + 1]; l += lanes<Real>) {
      const auto block = [&](int b) __attribute__((always_inline)) {
        return load_transposed<Row::stride>(&local->x, &list.index[l], b);
      };
      const auto [x, y, z, V] = block(0);
      const P dx = me.x - x, dy = me.y - y, dz = me.z - z;
      const P r2 = dx * dx + (dy * dy + (dz * dz + real(1e-12)));  // 1/r stays finite at r = 0
      const P inverse_r = inverse_sqrt(r2);
      P factor, h_ij = P{} + real(1);
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

      const auto [vx, vy, vz, c] = block(1);
      const P ux = me.vx - vx, uy = me.vy - vy, uz = me.vz - vz;
      gxx -= ux * wx, gxy -= ux * wy, gxz -= ux * wz;
      gyx -= uy * wx, gyy -= uy * wy, gyz -= uy * wz;
      gzx -= uz * wx, gzy -= uz * wy, gzz -= uz * wz;

      // Monaghan (1992) viscosity as a pair pressure q = rho_h (-alpha c mu + beta mu^2), with
      // rho_h = 2m/(V_i + V_j) the harmonic mean density; only approaching pairs feel it.
      const P approach = positive_part(P(-(ux * dx + uy * dy + uz * dz)));
      const P V_sum = me.V + V, distance2 = r2 + real(Viscosity::epsilon);
      P thrust = approach * inverse(P(distance2 * V_sum));
      if constexpr (extended) thrust *= h_ij;
      const P mu = thrust * V_sum;
      const P q = two_m * thrust * (half_alpha * (me.c + c) + beta * mu);

      const auto [t0, t1, t2, t3] = block(2);
      const auto [t4, t5, t6, t7] = block(3);
      const auto [t8, unused0, unused1, unused2] = block(4);
      wx_sum += wx, wy_sum += wy, wz_sum += wz;
      fx += (t0 - q) * wx + t1 * wy + t2 * wz;
      fy += t3 * wx + (t4 - q) * wy + t5 * wz;
      fz += t6 * wx + t7 * wy + (t8 - q) * wz;

      if constexpr (extended) {
        heat -= q * w * approach;  // v_ij . x_ij is -approach
        if (extra_.artificial_stress) {
          const auto [r0, r1, r2_, r3] = block(5);
          const auto [r4, r5, inverse_h, weight] = block(6);
          const P f = Kernel::w(P(r2 * inverse_r)) * real(inverse_w_spacing_);
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
    const P sums[] = {cxx, cyy, czz, cxy, cxz,    cyz,    gxx,    gxy, gxz, gyx, gyy,
                      gyz, gzx, gzy, gzz, wx_sum, wy_sum, wz_sum, fx,  fy,  fz,  heat};
    lane_sums(sums, out.s);
    // The particle's own flux is the same in every pair.
    const Real *w = out.s + Raw::w, *T = me.T;
    for (int a = 0; a < 3; ++a, T += 3)
      out.s[Raw::force + a] += T[0] * w[0] + T[1] * w[1] + T[2] * w[2];
  }

  /// Sums of lanes<Real> particles with their normalisation, in SI.
  std::array<PackedSums, parts<Real>> scaled(const Raw* raw) const {
    const double one = Kernel::normalisation, per_h = one / h_;
    Pack<double> s[parts<Real>][Raw::stride];
    for (int b = 0; 4 * b < Raw::count; ++b) {
      const Columns<Real> four = load_transposed<Raw::stride>(raw->s, rising<Real>.data(), b);
      for (std::size_t p = 0; p < parts<Real>; ++p) {
        s[p][4 * b] = widened<Real>(four.c0, p), s[p][4 * b + 1] = widened<Real>(four.c1, p);
        s[p][4 * b + 2] = widened<Real>(four.c2, p), s[p][4 * b + 3] = widened<Real>(four.c3, p);
      }
    }
    std::array<PackedSums, parts<Real>> out;
    for (std::size_t p = 0; p < parts<Real>; ++p) {
      const Pack<double>*C = s[p] + Raw::C, *G = s[p] + Raw::G, *force = s[p] + Raw::force;
      out[p].C = splat(one) * SymTensorOf<Pack<double>>{C[0], C[1], C[2], C[3], C[4], C[5]};
      for (int k = 0; k < 9; ++k) out[p].G[k / 3][k % 3] = per_h * G[k];
      for (int a = 0; a < 3; ++a) out[p].force[a] = per_h * force[a];
      if constexpr (extended) out[p].heat = per_h / 2 * s[p][Raw::heat];
    }
    return out;
  }

  double h_, scaled_mass_;
  Viscosity viscosity_;
  ExtraTerms extra_;
  double inverse_w_spacing_;
};

}  // namespace eerie
