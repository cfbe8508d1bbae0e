#pragma once

#include <cstdint>
#include <vector>

#include "solver/base/tensor.hpp"
#include "solver/tree/neighbour_list.hpp"

namespace eerie {

/// What a neighbour contributes to pair sums: twenty numbers in five blocks of four, and eight
/// more in scenes with evolving smoothing lengths or artificial stress. Lengths are in units of
/// the scene's smoothing length h0.
/// Positions and velocities are relative to the first particle of the row's bucket, subtracted
/// in double, so that single precision keeps differences to a part in 1e7 of a bucket.
template <class Real, bool extended>
struct PairRow;

template <class Real>
struct alignas(4 * sizeof(Real)) PairRow<Real, false> {
  static constexpr int stride = 20;
  Real x, y, z;     ///< h0
  Real V;           ///< volume m/rho, h0^3
  Real vx, vy, vz;  ///< m/s
  Real c;           ///< sound speed, m/s
  Real T[9];        ///< momentum flux -p 1 + S L, row-major, Pa
  Real unused[3];
};
template <class Real>
struct alignas(4 * sizeof(Real)) PairRow<Real, true> : PairRow<Real, false> {
  static constexpr int stride = 28;
  Real R[6];       ///< artificial stress, xx yy zz xy xz yz, Pa
  Real inverse_h;  ///< h0/h
  Real weight;     ///< (h0/h)^5: its kernel gradient's normalisation over that of h0
};

/// Rows of all particles in memory order, and the copy of one bucket's surroundings.
template <class Real, bool extended>
class PairRows {
 public:
  using Row = PairRow<Real, extended>;

  /// `h0`: the scene's smoothing length, m.
  explicit PairRows(double h0) : h0_(h0), per_h0_(1 / h0), per_h0_cubed_(1 / (h0 * h0 * h0)) {}

  void resize(std::size_t particles) {
    rows_.resize(particles);
    origins_.resize(bucket_count(particles));
  }

  /// Takes the bucket's first particle as the origin of its rows. Before any set().
  void set_origin(std::size_t bucket, const Vec3& x, const Vec3& v) { origins_[bucket] = {x, v}; }

  void set(std::size_t i, const Vec3& x, const Vec3& v, double V, double c) {
    const Origin& o = origins_[i / bucket_size];
    const Vec3 d = (x - o.x) * per_h0_, u = v - o.v;
    Row& r = rows_[i];
    r.x = real(d.x), r.y = real(d.y), r.z = real(d.z), r.V = real(V * per_h0_cubed_);
    r.vx = real(u.x), r.vy = real(u.y), r.vz = real(u.z), r.c = real(c);
  }
  void set_flux(std::size_t i, const Mat3& T) {
    for (int k = 0; k < 9; ++k) rows_[i].T[k] = real(T[k / 3][k % 3]);
  }

  /// R in Pa; h in m.
  void set_extra(std::size_t i, const SymTensor& R, double h) requires extended {
    Row& r = rows_[i];
    r.R[0] = real(R.xx), r.R[1] = real(R.yy), r.R[2] = real(R.zz);
    r.R[3] = real(R.xy), r.R[4] = real(R.xz), r.R[5] = real(R.yz);
    const double ratio = h0_ / h, ratio2 = ratio * ratio;
    r.inverse_h = real(ratio), r.weight = real(ratio2 * ratio2 * ratio);
  }

  /// Copies the rows of `list` relative to the origin of `bucket`, with the dummy row last.
  void gather(std::size_t bucket, const NeighbourList& lists, std::vector<Row>& local) const {
    const BucketList& list = lists[bucket];
    local.resize(list.rows.size() + 1);
    const Origin& home = origins_[bucket];
    for (std::size_t k = 0; k < list.rows.size(); ++k) {
      const std::uint32_t j = list.rows[k];
      const Origin& o = origins_[j / bucket_size];
      const Vec3 d = (o.x - home.x) * per_h0_, u = o.v - home.v;
      Row& r = local[k];
      r = rows_[j];
      r.x += real(d.x), r.y += real(d.y), r.z += real(d.z);
      r.vx += real(u.x), r.vy += real(u.y), r.vz += real(u.z);
    }
    for (std::size_t k = 0; k < list.images.size(); ++k)
      if (list.images[k] > 0)
        local[k] = mirrored(list.rows[k], lists.images()[list.images[k] - 1u], home);
    // Far away, at rest, without volume: every pair with it contributes exactly nothing.
    local.back() = Row{};
    local.back().x = Real(1e9);
    if constexpr (extended) local.back().inverse_h = 1;
  }

 private:
  struct Origin {
    Vec3 x, v;
  };
  /// The row of particle j as seen in a mirror.
  Row mirrored(std::uint32_t j, const Image& image, const Origin& home) const {
    const Origin& o = origins_[j / bucket_size];
    Row r = rows_[j];
    const Vec3 at = o.x + h0_ * Vec3{double(r.x), double(r.y), double(r.z)};
    const Vec3 x = (image(at) - home.x) * per_h0_;
    const Vec3 v = image.velocity(o.v + Vec3{double(r.vx), double(r.vy), double(r.vz)}) - home.v;
    const Vec3& st = image.stress_sign;
    r.x = real(x.x), r.y = real(x.y), r.z = real(x.z);
    r.vx = real(v.x), r.vy = real(v.y), r.vz = real(v.z);
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) r.T[3 * a + b] *= real(st[a] * st[b]);
    if constexpr (extended)
      r.R[3] *= real(st.x * st.y), r.R[4] *= real(st.x * st.z), r.R[5] *= real(st.y * st.z);
    return r;
  }
  static Real real(double value) { return static_cast<Real>(value); }
  double h0_, per_h0_, per_h0_cubed_;
  std::vector<Row> rows_;
  std::vector<Origin> origins_;
};

}  // namespace eerie
