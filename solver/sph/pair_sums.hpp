#pragma once

#include <array>
#include <variant>
#include <vector>

#include "solver/base/simd/rows.hpp"
#include "solver/sph/kernel.hpp"
#include "solver/sph/pair_rows.hpp"

namespace eerie::sph {

/// Sums over the neighbours j of one particle i, where x_ij = x_i - x_j and v_ij = v_i - v_j. Where
/// T is a Pack they are the sums of several particles.
template <class T>
struct NeighbourSumsOf {
  SymTensorOf<T> C;  ///< -sum V_j grad_i W (x) x_ij, the identity inside a uniform body
  Mat3Of<T> G;       ///< -sum V_j v_ij (x) grad_i W, the uncorrected velocity gradient, 1/s
  /// sum V_j (T_i + T_j - q_ij 1) . grad_i W, that is rho_i dv_i/dt, Pa/m.
  std::conditional_t<std::is_same_v<T, double>, Vec3, std::array<T, 3>> force{};
  T heat{};  ///< 1/2 sum V_j q_ij v_ij . grad_i W, that is rho_i du_i/dt of viscosity, W/m^3
  /// The part of the force that viscosity makes, Pa/m; with Terms::all artificial stress too.
  std::array<T, 3> brake{};
  /// -1/6 sum V_j q_ij x_ij . grad_i W, the pressure that viscosity carries, Pa.
  T viscous_pressure{};
};
using NeighbourSums = NeighbourSumsOf<double>;
using PackedSums = NeighbourSumsOf<Pack<double>>;

/// The sums of one particle, lane l of several.
inline NeighbourSums lane(const PackedSums& s, std::size_t l) {
  NeighbourSums one;
  one.C = {s.C.xx[l], s.C.yy[l], s.C.zz[l], s.C.xy[l], s.C.xz[l], s.C.yz[l]};
  for (int k = 0; k < 9; ++k) one.G[k / 3][k % 3] = s.G[k / 3][k % 3][l];
  one.force = {s.force[0][l], s.force[1][l], s.force[2][l]};
  one.brake = {s.brake[0][l], s.brake[1][l], s.brake[2][l]};
  one.heat = s.heat[l];
  one.viscous_pressure = s.viscous_pressure[l];
  return one;
}

struct Viscosity {
  double alpha, beta;
  static constexpr double epsilon = 0.01;  ///< in units of h^2; keeps mu finite (Monaghan 1992)
};

/// Terms that few scenes need. A flag that is off leaves its term out.
struct ExtraTerms {
  bool unlike_h = false;
  bool artificial_stress = false;  ///< q_ij 1 becomes q_ij 1 - (R_i + R_j) f^4, f = W/W(spacing)
  double spacing = 0;              ///< spacing of particles at rest, m
  bool shear_free = false;         ///< viscosity ignores shear, as with Terms::shear_free
};

/// The visit of all neighbours in a step, for one floating-point type and one kernel. It makes all
/// sums in one visit of each pair. Only Terms::all has heat and ExtraTerms. One thread makes each
/// sum, in list order. The same thread then calls `finish(i, count, sums)` for the particles i to i
/// + count - 1, where lane l of `sums` belongs to i + l.
///
/// A visit has four short loops over the pairs of a particle, one pack at a time, and keeps their
/// numbers in memory in between. One long loop would wait for the latency of square roots and
/// divisions. Geometry and viscosity need the numbers of several neighbours side by side, which
/// takes a transposition. Fluxes are only weighed and added row by row, and need none.
template <class Real, class Kernel, Terms terms = Terms::basic>
class PairSums {
 public:
  using Number = Real;
  static constexpr bool sheared = terms != Terms::basic, extended = terms == Terms::all;
  PairRows<Real, terms> rows;

  /// `h` is the scene's smoothing length, m, and `mass` that of a particle, kg.
  PairSums(double h, double mass, Viscosity viscosity, ExtraTerms extra = {})
      : rows(h),
        h_(h),
        scaled_mass_(mass / (h * h * h)),
        viscosity_(viscosity),
        extra_(extra),
        inverse_w_spacing_(extra.spacing > 0 ? 1 / Kernel::w(extra.spacing / h) : 0) {}

  template <Part asked = Part::all, class Finish>
  void sweep(const tree::NeighbourList& lists, std::size_t particles, Finish&& finish) const {
    constexpr Part part = extended ? Part::all : asked;  // rare terms share one loop
#pragma omp parallel
    {
      Desk desk;
#pragma omp for schedule(dynamic, 2)
      for (std::size_t b = 0; b < lists.buckets(); ++b) {
        rows.template gather<part>(b, lists, desk.local);
        const std::size_t first = b * tree::bucket_size,
                          n = std::min(tree::bucket_size, particles - first);
        for (std::size_t k = 0; k < n; ++k) sum<part>(k, lists[b], desk);
        for (std::size_t k = 0; k < n; k += lanes<Real>) {
          std::size_t at = k;
          for (const PackedSums& sums : scaled<part>(desk, k)) {
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

  /// A pack of pairs: the differences between particle and neighbours, and numbers that follow from
  /// them.
  struct Pairs {
    P dx, dy, dz;  ///< h0
    P ux, uy, uz;  ///< m/s
    P r2;          ///< h0^2
    P approach;    ///< -u.dx where that is positive; without shear, where viscosity ignores it
    P V, c_sum;    ///< volume of the neighbour; sum of both sound speeds
    P w;           ///< V_j (dW/dr)/r, without normalisation
    P thrust;      ///< w q over twice the mass, where q is the pair pressure of viscosity
  };
  struct ExtraPairs {
    Columns<Real> row;
    P closing;  ///< -u.dx
    P f4_w;     ///< (W/W(spacing))^4 w
  };
  /// The sums of one particle, without their normalisation.
  struct alignas(64) Raw {
    static constexpr int C = 0, G = 6, heat = 15, flux = 16, repulsion = 32, virial = 35;
    static constexpr std::size_t count = extended ? 48 : 32;
    Real s[count];
  };
  /// The working memory of one thread.
  struct Desk {
    Rows<Real, terms> local;
    std::vector<Pairs> pairs;
    std::vector<ExtraPairs> extra;
    std::vector<std::array<P, 4>> weights;
    std::vector<Raw> raw = std::vector<Raw>(tree::bucket_size + lanes<Real>);
  };

  /// Makes the sums of one particle. The entries of its list are places of rows of eight.
  template <Part part>
  void sum(std::size_t k, const tree::BucketList& list, Desk& desk) const {
    const std::uint16_t* places = list.index.data() + list.begin[k];
    const std::size_t packs = (list.begin[k + 1] - list.begin[k]) / lanes<Real>;
    if (desk.pairs.size() < packs) {
      desk.pairs.resize(2 * packs), desk.weights.resize(2 * packs);
      if constexpr (extended) desk.extra.resize(2 * packs);
    }
    for (std::size_t p = 0; p < packs; ++p) separate<part>(k, places + p * lanes<Real>, desk, p);
    for (std::size_t p = 0; p < packs; ++p) weigh<part>(k, desk, p);
    if constexpr (part == Part::viscous) return add_thrusts(k, desk, packs);
    if constexpr (part == Part::force)
      for (std::size_t p = 0; p < packs; ++p) store_weights(desk, p);
    else
      add_gradients<part>(k, desk, packs);
    if constexpr (part != Part::gradient)
      add_fluxes(places, desk, packs, desk.raw[k].s + Raw::flux);
  }

  /// Computes the differences of position and velocity.
  template <Part part>
  void separate(std::size_t k, const std::uint16_t* places, Desk& desk, std::size_t p) const {
    const MotionRow<Real>& me = desk.local.motion[k];
    const auto [row] = load_columns(&desk.local.motion[0].x, places);
    const P dx = me.x - row[0], dy = me.y - row[1], dz = me.z - row[2];
    const P ux = me.vx - row[4], uy = me.vy - row[5], uz = me.vz - row[6];
    Pairs& pairs = desk.pairs[p];
    pairs.dx = dx, pairs.dy = dy, pairs.dz = dz, pairs.ux = ux, pairs.uy = uy, pairs.uz = uz;
    pairs.r2 = dx * dx + (dy * dy + (dz * dz + real(1e-12)));  // keeps 1/r finite at r = 0
    pairs.V = row[3];
    if constexpr (part == Part::gradient) return;
    const P closing = -(ux * dx + uy * dy + uz * dz);
    pairs.approach = positive_part(closing);
    if constexpr (sheared)
      if (!extended || extra_.shear_free)
        pairs.approach = without_shear(pairs, closing, desk.local.shear, k, places);
    pairs.c_sum = me.c + row[7];
    if constexpr (extended) {
      desk.extra[p].row = load_columns(desk.local.extra[0].R, places);
      desk.extra[p].closing = closing;
    }
  }

  /// The approach of a pair without the shear of its neighbourhood. It never exceeds the whole
  /// approach, so that viscosity only removes energy.
  P without_shear(const Pairs& pairs, P closing, const std::vector<ShearRow<Real>>& shear,
                  std::size_t k, const std::uint16_t* places) const {
    const Real* mine = shear[k].e;
    const auto [e] = load_columns(shear[0].e, places);
    const P dx = pairs.dx, dy = pairs.dy, dz = pairs.dz;
    const P along =
        (mine[0] + e[0]) * dx * dx + (mine[1] + e[1]) * dy * dy + (mine[2] + e[2]) * dz * dz +
        real(2) *
            ((mine[3] + e[3]) * dx * dy + (mine[4] + e[4]) * dx * dz + (mine[5] + e[5]) * dy * dz);
    const P rest = closing + along;
    return positive_part(P(rest < closing ? rest : closing));
  }

  /// Computes the gradient of the kernel and the viscosity.
  template <Part part>
  void weigh(std::size_t k, Desk& desk, std::size_t p) const {
    Pairs& pairs = desk.pairs[p];
    const P r2 = pairs.r2, inverse_r = inverse_sqrt(r2), r = r2 * inverse_r;
    P slope{}, h_ij = splat(real(1));
    bool evolving = false;
    if constexpr (extended) {
      if (extra_.unlike_h) {
        evolving = true;
        const P mine = splat(desk.local.extra[k].inverse_h), other = desk.extra[p].row.c[6];
        slope = real(0.5) * (desk.local.extra[k].weight * slope_of(r, inverse_r, mine) +
                             desk.extra[p].row.c[7] * slope_of(r, inverse_r, other));
        h_ij = real(2) * inverse(P(mine + other));
      }
    }
    if (!evolving) slope = Kernel::dw_over_q(r, inverse_r);
    pairs.w = pairs.V * slope;
    if constexpr (part == Part::gradient) return;

    // The viscosity of Monaghan (1992) as a pair pressure q = rho_h (-alpha c mu + beta mu^2),
    // where rho_h = 2m/(V_i + V_j) is the harmonic mean density. Only approaching pairs have it.
    const P V_sum = desk.local.motion[k].V + pairs.V;
    P push = pairs.approach * inverse(P((r2 + real(Viscosity::epsilon)) * V_sum));
    if constexpr (extended) push *= h_ij;
    const P mu = push * V_sum;
    pairs.thrust =
        push * (real(viscosity_.alpha / 2) * pairs.c_sum + real(viscosity_.beta) * mu) * pairs.w;
    if constexpr (extended) {
      const P f = Kernel::w(r) * real(inverse_w_spacing_);
      desk.extra[p].f4_w = f * f * f * f * pairs.w;
    }
  }
  /// (dW/dr)/r for the smoothing length h0/inverse_h, without its weight.
  P slope_of(P r, P inverse_r, P inverse_h) const {
    return Kernel::dw_over_q(P(r * inverse_h), P(inverse_r * inverse(inverse_h)));
  }

  static void store_weights(Desk& desk, std::size_t p) {
    const Pairs& pairs = desk.pairs[p];
    store_quads<Real>(P(pairs.w * pairs.dx), P(pairs.w * pairs.dy), P(pairs.w * pairs.dz),
                      pairs.thrust, weights(desk, p));
  }

  /// Adds to C and G, and computes the weights of the fluxes.
  template <Part part>
  void add_gradients(std::size_t k, Desk& desk, std::size_t packs) const {
    P cxx{}, cyy{}, czz{}, cxy{}, cxz{}, cyz{}, heat{};
    P gxx{}, gxy{}, gxz{}, gyx{}, gyy{}, gyz{}, gzx{}, gzy{}, gzz{};
    [[maybe_unused]] P repulsion[4] = {};  // the last entry is the virial of viscosity
    for (std::size_t p = 0; p < packs; ++p) {
      const Pairs& pairs = desk.pairs[p];
      const P dx = pairs.dx, dy = pairs.dy, dz = pairs.dz;
      const P ux = pairs.ux, uy = pairs.uy, uz = pairs.uz;
      const P wx = pairs.w * dx, wy = pairs.w * dy, wz = pairs.w * dz;
      if constexpr (part != Part::gradient)
        store_quads<Real>(wx, wy, wz, pairs.thrust, weights(desk, p));
      cxx -= wx * dx, cyy -= wy * dy, czz -= wz * dz;
      cxy -= wx * dy, cxz -= wx * dz, cyz -= wy * dz;
      gxx -= ux * wx, gxy -= ux * wy, gxz -= ux * wz;
      gyx -= uy * wx, gyy -= uy * wy, gyz -= uy * wz;
      gzx -= uz * wx, gzy -= uz * wy, gzz -= uz * wz;
      if constexpr (extended) {
        heat -= real(2 * scaled_mass_) * pairs.thrust * desk.extra[p].closing;  // v_ij . x_ij
        repulsion[3] -= real(2 * scaled_mass_) * pairs.thrust * pairs.r2;
        if (extra_.artificial_stress) {
          const Real* mine = desk.local.extra[k].R;
          const ExtraPairs& extra = desk.extra[p];
          const P* R = extra.row.c;
          const P ax = extra.f4_w * dx, ay = extra.f4_w * dy, az = extra.f4_w * dz;
          const P xy = mine[3] + R[3], xz = mine[4] + R[4], yz = mine[5] + R[5];
          const P fx = (mine[0] + R[0]) * ax + xy * ay + xz * az,
                  fy = xy * ax + (mine[1] + R[1]) * ay + yz * az,
                  fz = xz * ax + yz * ay + (mine[2] + R[2]) * az;
          repulsion[0] += fx, repulsion[1] += fy, repulsion[2] += fz;
          heat -= fx * ux + fy * uy + fz * uz;
        }
      }
    }
    const P sums[] = {cxx, cyy, czz, cxy, cxz, cyz, gxx, gxy,
                      gxz, gyx, gyy, gyz, gzx, gzy, gzz, heat};
    lane_sums(sums, desk.raw[k].s);
    if constexpr (extended) lane_sums(repulsion, desk.raw[k].s + Raw::repulsion);
  }
  static void add_thrusts(std::size_t k, Desk& desk, std::size_t packs) {
    P sums[4] = {};
    for (std::size_t p = 0; p < packs; ++p) {
      const Pairs& pairs = desk.pairs[p];
      sums[0] -= pairs.thrust * pairs.dx;
      sums[1] -= pairs.thrust * pairs.dy;
      sums[2] -= pairs.thrust * pairs.dz;
    }
    lane_sums(sums, desk.raw[k].s + Raw::flux);
  }
  static Real* weights(Desk& desk, std::size_t p) {
    return reinterpret_cast<Real*>(&desk.weights[p]);
  }

  static const Real* first(const Quad<Real>& q) { return reinterpret_cast<const Real*>(&q); }

  /// Adds the rows of the stresses: gradient of the kernel times flux, thrust times position.
  static void add_fluxes(const std::uint16_t* places, Desk& desk, std::size_t packs, Real* out) {
    QuadSums<Real> sums;
    for (std::size_t p = 0; p < packs; ++p)
      sums.add(weights(desk, p), first(desk.local.stress[0].q[0]), places + p * lanes<Real>);
    sums.store(out);
  }

  /// The sums of lanes<Real> particles from the k-th on, normalised, in SI.
  template <Part part>
  std::array<PackedSums, parts<Real>> scaled(const Desk& desk, std::size_t k) const {
    P raw[Raw::count], own[16];
    constexpr std::size_t begin = part == Part::force || part == Part::viscous ? Raw::flux : 0,
                          end = part == Part::gradient  ? Raw::flux
                                : part == Part::viscous ? Raw::flux + 8
                                                        : Raw::count;
    for (std::size_t at = begin; at < end; at += 8) {
      const auto eight = load_columns(desk.raw[k].s + at, rising<Real, Raw::count>.data());
      std::copy(eight.c, eight.c + 8, raw + at);
    }
    std::array<PackedSums, parts<Real>> out;
    if constexpr (part == Part::viscous) {
      for (std::size_t p = 0; p < parts<Real>; ++p)
        for (std::size_t a = 0; a < 3; ++a)
          out[p].brake[a] = (2 * scaled_mass_ * Kernel::normalisation / h_) *
                            widened<Real>(raw[Raw::flux + a], p);
      return out;
    }
    if constexpr (part != Part::force) take_gradients(raw, out);
    if constexpr (part == Part::gradient) return out;
    for (std::size_t b = 0; b < 2; ++b) {
      const auto eight =
          load_columns(first(desk.local.stress[k].q[2 * b]), rising<Real, 16>.data());
      std::copy(eight.c, eight.c + 8, own + 8 * b);
    }
    const P *flux = raw + Raw::flux, *gradient = flux + 12;
    const double one = Kernel::normalisation, per_h = one / h_;
    for (std::size_t p = 0; p < parts<Real>; ++p) {
      const auto get = [&](P x, double factor) { return factor * widened<Real>(x, p); };
      for (int a = 0; a < 3; ++a) {
        const P *theirs = flux + 4 * a, *mine = own + 4 * a;
        // sum (T_i + T_j) . grad W, and x_j sum_thrust - x_i sum_thrust.
        const P pull = (theirs[0] + theirs[1] + theirs[2]) + mine[0] * gradient[0] +
                       mine[1] * gradient[1] + mine[2] * gradient[2];
        const P push = theirs[3] - mine[3] * gradient[3];
        P force = pull + real(2 * scaled_mass_) * push;
        if constexpr (part == Part::force)
          out[p].brake[static_cast<std::size_t>(a)] = get(push, 2 * scaled_mass_ * per_h);
        if constexpr (extended) {
          force += raw[Raw::repulsion + a];
          out[p].brake[static_cast<std::size_t>(a)] =
              get(P(real(2 * scaled_mass_) * push + raw[Raw::repulsion + a]), per_h);
        }
        out[p].force[static_cast<std::size_t>(a)] = get(force, per_h);
      }
      if constexpr (extended) {
        out[p].heat = get(raw[Raw::heat], per_h / 2);
        out[p].viscous_pressure = get(raw[Raw::virial], one / 6);
      }
    }
    return out;
  }

  void take_gradients(const P* raw, std::array<PackedSums, parts<Real>>& out) const {
    const double one = Kernel::normalisation, per_h = one / h_;
    for (std::size_t p = 0; p < parts<Real>; ++p) {
      const auto get = [&](P x, double factor) { return factor * widened<Real>(x, p); };
      const P* C = raw + Raw::C;
      out[p].C = {get(C[0], one), get(C[1], one), get(C[2], one),
                  get(C[3], one), get(C[4], one), get(C[5], one)};
      for (int i = 0; i < 9; ++i) out[p].G[i / 3][i % 3] = get(raw[Raw::G + i], per_h);
    }
  }

  double h_, scaled_mass_;
  Viscosity viscosity_;
  ExtraTerms extra_;
  double inverse_w_spacing_;
};

}  // namespace eerie::sph
