#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#include "solver/base/simd/rows.hpp"
#include "solver/base/tensor.hpp"
#include "solver/tree/neighbour_list.hpp"

namespace eerie::sph {

// The numbers of a neighbour that pair sums use, in rows of eight or sixteen. Lengths are in units
// of the scene's smoothing length h0. Positions and velocities are relative to the first particle
// of a bucket. They are subtracted in double precision, so single precision resolves 1e-7 of the
// size of a bucket.

/// Position and velocity of a particle, its volume and its sound speed.
template <class Real>
struct alignas(8 * sizeof(Real)) MotionRow {
  Real x, y, z;     ///< h0
  Real V;           ///< volume m/rho, h0^3
  Real vx, vy, vz;  ///< m/s
  Real c;           ///< sound speed, m/s
};

/// The rows of a momentum flux, Pa. The fourth number of each has no meaning.
using FluxRows = std::array<Quad<double>, 3>;
inline FluxRows rows_of(const Mat3& T) {
  FluxRows rows;
  for (int a = 0; a < 3; ++a)
    rows[static_cast<std::size_t>(a)] = Quad<double>{T[a][0], T[a][1], T[a][2], 0};
  return rows;
}

/// The momentum flux T = -p 1 + S L, Pa. A coordinate (h0) follows each of its rows, and a row of
/// ones ends it. Pair sums weigh these with the gradient of the kernel and with the thrust of
/// viscosity (pair_sums.hpp).
template <class Real>
struct alignas(64) StressRow {
  Quad<Real> q[4] = {
      {}, {}, {}, {1, 1, 1, 1}};  ///< T_xx T_xy T_xz x, T_yx T_yy T_yz y, T_zx T_zy T_zz z, 1 1 1 1
};

/// The terms of the pair sums. Scenes that need fewer terms do not pay for the others.
enum class Terms {
  basic,       ///< fluxes and Monaghan's viscosity
  shear_free,  ///< viscosity ignores the local shear
  all,  ///< adds heat, evolving smoothing lengths, artificial stress, the pressure of viscosity
};

/// The sums that one visit of the neighbours makes.
enum class Part {
  all,       ///< all of them
  gradient,  ///< C and G, which need positions and velocities only
  force,     ///< the force and the sums of viscosity
  viscous,   ///< the force of viscosity alone, once more for other velocities
};

/// The shear of the neighbourhood, for viscosity that ignores shear.
template <class Real>
struct alignas(8 * sizeof(Real)) ShearRow {
  Real e[6];  ///< half the traceless strain rate, xx yy zz xy xz yz, times h0, m/s
  Real unused[2]{};
};

/// The numbers for evolving smoothing lengths and artificial stress.
template <class Real>
struct alignas(8 * sizeof(Real)) ExtraRow {
  Real R[6];       ///< artificial stress, xx yy zz xy xz yz, Pa
  Real inverse_h;  ///< h0/h
  Real weight;     ///< (h0/h)^5, the normalisation of its kernel gradient relative to that for h0
};

/// The rows of some particles, one of each kind per particle.
template <class Real, Terms terms>
struct Rows {
  std::vector<MotionRow<Real>> motion;
  std::vector<StressRow<Real>> stress;
  std::vector<ShearRow<Real>> shear;
  std::vector<ExtraRow<Real>> extra;

  void resize(std::size_t n) {
    motion.resize(n), stress.resize(n);
    if constexpr (terms != Terms::basic) shear.resize(n);
    if constexpr (terms == Terms::all) extra.resize(n);
  }
  void grow_to(std::size_t n) {
    if (motion.size() < n) resize(n);
  }
};

/// The rows of all particles in memory order. gather() copies those around one bucket.
template <class Real, Terms terms>
class PairRows {
 public:
  static constexpr bool sheared = terms != Terms::basic, extended = terms == Terms::all;

  /// `h0`: the scene's smoothing length, m.
  explicit PairRows(double h0) : h0_(h0), per_h0_(1 / h0), per_h0_cubed_(1 / (h0 * h0 * h0)) {}

  void resize(std::size_t particles) {
    rows_.resize(particles);
    origins_.resize(tree::bucket_count(particles));
  }

  /// Takes the first particle of each bucket as the origin of its rows. Goes before any set().
  void set_origin(std::size_t bucket, const Vec3& x, const Vec3& v) { origins_[bucket] = {x, v}; }

  /// Sets the rows of a particle: x in m, v and c in m/s, V in m^3, rows of T in Pa.
  void set(std::size_t i, const Vec3& x, const Vec3& v, double V, double c, const FluxRows& T) {
    set_motion(i, x, v, V, c);
    const Vec3 d = (x - origins_[i / tree::bucket_size].x) * per_h0_;
    for (int a = 0; a < 3; ++a) {
      rows_.stress[i].q[a] = __builtin_convertvector(T[static_cast<std::size_t>(a)], Quad<Real>);
      rows_.stress[i].q[a][3] = real(d[a]);
    }
  }

  /// Sets the numbers that Part::gradient needs.
  void set_motion(std::size_t i, const Vec3& x, const Vec3& v, double V, double c = 0) {
    const Origin& o = origins_[i / tree::bucket_size];
    const Vec3 d = (x - o.x) * per_h0_, u = v - o.v;
    rows_.motion[i] = {real(d.x), real(d.y), real(d.z), real(V * per_h0_cubed_),
                       real(u.x), real(u.y), real(u.z), real(c)};
  }

  /// Sets another velocity, m/s.
  void set_velocity(std::size_t i, const Vec3& v) {
    const Vec3 u = v - origins_[i / tree::bucket_size].v;
    rows_.motion[i].vx = real(u.x), rows_.motion[i].vy = real(u.y), rows_.motion[i].vz = real(u.z);
  }

  /// Sets the traceless strain rate e, 1/s.
  void set_shear(std::size_t i, const SymTensorf& e) requires sheared {
    const double s = h0_ / 2;
    rows_.shear[i] = {{real(s * e.xx), real(s * e.yy), real(s * e.zz), real(s * e.xy),
                       real(s * e.xz), real(s * e.yz)}};
  }

  /// Sets the artificial stress R, Pa, and the smoothing length h, m.
  void set_extra(std::size_t i, const SymTensor& R, double h) requires extended {
    const double ratio = h0_ / h, ratio2 = ratio * ratio;
    rows_.extra[i] = {{real(R.xx), real(R.yy), real(R.zz), real(R.xy), real(R.xz), real(R.yz)},
                      real(ratio),
                      real(ratio2 * ratio2 * ratio)};
  }

  /// Copies the rows of `list` relative to the origin of `bucket`, with the dummy row last. Rows
  /// that `part` does not need stay undefined.
  template <Part part = Part::all>
  void gather(std::size_t bucket, const tree::NeighbourList& lists,
              Rows<Real, terms>& local) const {
    const tree::BucketList& list = lists[bucket];
    const std::size_t dummy = list.rows.size();
    local.grow_to(std::max(dummy + 1, tree::bucket_size));
    const Origin& home = origins_[bucket];
    std::size_t from = bucket;
    Shift shift;
    for (std::size_t k = 0; k < list.rows.size(); ++k) {
      const std::uint32_t j = list.rows[k];
      if (j / tree::bucket_size != from) {
        from = j / tree::bucket_size;
        shift = Shift((origins_[from].x - home.x) * per_h0_, origins_[from].v - home.v);
      }
      add(rows_.motion[j], shift.motion, local.motion[k]);
      if constexpr (part == Part::gradient) continue;
      if constexpr (part != Part::viscous) add(rows_.stress[j], shift.stress, local.stress[k]);
      if constexpr (sheared) local.shear[k] = rows_.shear[j];
      if constexpr (extended) local.extra[k] = rows_.extra[j];
    }
    for (std::size_t k = 0; k < list.images.size(); ++k)
      if (list.images[k] > 0)
        mirror(list.rows[k], lists.images()[list.images[k] - 1u], home, local, k);
    // The dummy row is far away, at rest and without volume, so every pair with it contributes
    // exactly zero.
    local.motion[dummy] = {Real(1e9), 0, 0, 0, 0, 0, 0, 0};
    for (Quad<Real>& q : local.stress[dummy].q) q = Quad<Real>{};
    if constexpr (sheared) local.shear[dummy] = {};
    if constexpr (extended) local.extra[dummy] = {{}, 1, 0};
  }

 private:
  struct Origin {
    Vec3 x, v;
  };

  /// The difference between the origins of two buckets, as rows to add. Zeros leave the rest alone.
  struct Shift {
    MotionRow<Real> motion{};
    StressRow<Real> stress{{{}, {}, {}, {}}};
    Shift() = default;
    Shift(const Vec3& dx, const Vec3& dv)
        : motion{real(dx.x), real(dx.y), real(dx.z), 0, real(dv.x), real(dv.y), real(dv.z), 0} {
      for (int a = 0; a < 3; ++a) stress.q[a][3] = real(dx[a]);
    }
  };
  /// sum = row + shift, number by number, in as few instructions as the machine has.
  template <class Row>
  static void add(const Row& row, const Row& shift, Row& sum) {
    typedef Real Numbers __attribute__((vector_size(sizeof(Row))));
    Numbers a, b;
    std::memcpy(&a, &row, sizeof a);
    std::memcpy(&b, &shift, sizeof b);
    a += b;
    std::memcpy(static_cast<void*>(&sum), &a, sizeof a);
  }

  /// Replaces row k by the mirror image of particle j.
  void mirror(std::uint32_t j, const tree::MirrorImage& image, const Origin& home,
              Rows<Real, terms>& local, std::size_t k) const {
    const Origin& o = origins_[j / tree::bucket_size];
    const MotionRow<Real>& r = rows_.motion[j];
    const Vec3 at = o.x + h0_ * Vec3{double(r.x), double(r.y), double(r.z)};
    const Vec3 x = (image(at) - home.x) * per_h0_;
    const Vec3 v = image.velocity(o.v + Vec3{double(r.vx), double(r.vy), double(r.vz)}) - home.v;
    local.motion[k] = {real(x.x), real(x.y), real(x.z), r.V, real(v.x), real(v.y), real(v.z), r.c};
    const Vec3& st = image.stress_sign;
    for (int a = 0; a < 3; ++a) {
      const Quad<Real> signs = {real(st[a] * st.x), real(st[a] * st.y), real(st[a] * st.z), 0};
      local.stress[k].q[a] = rows_.stress[j].q[a] * signs;
      local.stress[k].q[a][3] = real(x[a]);
    }
    const auto turn = [&](Real* t) {
      t[3] *= real(st.x * st.y), t[4] *= real(st.x * st.z), t[5] *= real(st.y * st.z);
    };
    // A rough wall keeps the shear as it keeps the stress: velocity continues linearly through it.
    if constexpr (sheared) turn(local.shear[k].e);
    if constexpr (extended) turn(local.extra[k].R);
  }

  static Real real(double value) { return static_cast<Real>(value); }
  double h0_, per_h0_, per_h0_cubed_;
  Rows<Real, terms> rows_;
  std::vector<Origin> origins_;
};

}  // namespace eerie::sph
