#pragma once

#include <cstdint>
#include <vector>

#include "solver/base/tensor.hpp"
#include "solver/tree/neighbour_list.hpp"

namespace eerie {

/// What a neighbour contributes to pair sums: twenty numbers in five blocks of four.
/// Positions and velocities are relative to the first particle of the row's bucket, subtracted
/// in double, so that single precision keeps differences to a part in 1e7 of a bucket.
template <class Real>
struct alignas(4 * sizeof(Real)) PairRow {
  static constexpr int stride = 20, geometry_blocks = 2, blocks = 5;
  Real x, y, z;     ///< m
  Real V;           ///< volume m/rho, m^3
  Real vx, vy, vz;  ///< m/s
  Real rho;         ///< kg/m^3
  Real T[9];        ///< momentum flux -p 1 + S L, row-major, Pa
  Real c;           ///< sound speed, m/s
  Real unused[2];
};

/// Rows of all particles in memory order, and the copy of one bucket's surroundings.
template <class Real>
class PairRows {
 public:
  using Row = PairRow<Real>;

  void resize(std::size_t particles) {
    rows_.resize(particles);
    origins_.resize(bucket_count(particles));
  }

  /// Takes the bucket's first particle as the origin of its rows. Before any set().
  void set_origin(std::size_t bucket, const Vec3& x, const Vec3& v) { origins_[bucket] = {x, v}; }

  void set(std::size_t i, const Vec3& x, const Vec3& v, double V, double rho, double c) {
    const Origin& o = origins_[i / bucket_size];
    Row& r = rows_[i];
    r.x = real(x.x - o.x.x), r.y = real(x.y - o.x.y), r.z = real(x.z - o.x.z);
    r.vx = real(v.x - o.v.x), r.vy = real(v.y - o.v.y), r.vz = real(v.z - o.v.z);
    r.V = real(V), r.rho = real(rho), r.c = real(c);
  }
  void set_flux(std::size_t i, const Mat3& T) {
    for (int k = 0; k < 9; ++k) rows_[i].T[k] = real(T[k / 3][k % 3]);
  }

  /// Copies the rows of `list` relative to the origin of `bucket`, with the dummy row last.
  void gather(std::size_t bucket, const BucketList& list, std::vector<Row>& local) const {
    local.resize(list.rows.size() + 1);
    const Origin& home = origins_[bucket];
    for (std::size_t k = 0; k < list.rows.size(); ++k) {
      const std::uint32_t j = list.rows[k];
      const Origin& o = origins_[j / bucket_size];
      Row& r = local[k];
      r = rows_[j];
      r.x += real(o.x.x - home.x.x), r.y += real(o.x.y - home.x.y), r.z += real(o.x.z - home.x.z);
      r.vx += real(o.v.x - home.v.x), r.vy += real(o.v.y - home.v.y),
          r.vz += real(o.v.z - home.v.z);
    }
    // Far away, at rest, without volume: every pair with it contributes exactly nothing.
    local.back() = Row{};
    local.back().x = Real(1e9);
    local.back().rho = 1;
  }

 private:
  struct Origin {
    Vec3 x, v;
  };
  static Real real(double value) { return static_cast<Real>(value); }
  std::vector<Row> rows_;
  std::vector<Origin> origins_;
};

}  // namespace eerie
