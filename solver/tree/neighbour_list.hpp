#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "solver/base/tensor.hpp"
#include "solver/tree/images.hpp"
#include "solver/tree/kd_tree.hpp"

namespace eerie::tree {

/// Neighbours of one bucket: the union of all particles near it (its own first), and for each
/// of its particles the list of their places in that union, times the row units of the
/// NeighbourList.
/// Lists are padded to a multiple of `padding` with the union's length, the place of a dummy row
/// that contributes nothing.
struct BucketList {
  std::vector<std::uint32_t> rows;                     ///< particles, by memory index
  std::vector<std::uint8_t> images;                    ///< with walls, of each row: see MirrorImage
  std::vector<std::uint16_t> index;                    ///< all lists one after another
  std::array<std::uint32_t, bucket_size + 1> begin{};  ///< list k: index[begin[k]..begin[k+1])

  /// Where row `place` is, whose particle is at `x`: there, or in its mirror.
  Vec3 as_seen(std::size_t place, const Vec3& x, const std::vector<MirrorImage>& mirrors) const {
    const std::size_t image = images.empty() ? 0 : images[place];
    return image == 0 ? x : mirrors[image - 1](x);
  }
};

/// Neighbour lists of all buckets with a search radius beyond the support (Verlet skin): they
/// hold every pair closer than the support until an unlisted pair has come closer by the skin.
/// That is judged relative to the rigid motion of the bulk, so that a settled body that flies
/// and spins needs no new lists; loose particles with few neighbours are judged by the real
/// distance to the nearest one that they do not list. All of it is a pure function of memory
/// order and positions, for any number of threads. With walls, mirror images of particles are
/// neighbours too, and lists are judged by plain displacement.
class NeighbourList {
 public:
  static constexpr std::size_t padding = 16;

  /// `support`: kernel support radius, m; `skin`: extra radius, m; `row_units`: what entries of
  /// the lists are multiplied by, so that they serve as offsets of rows of some length.
  NeighbourList(double support, double skin, std::vector<MirrorImage> images = {},
                std::size_t row_units = 1)
      : support_(support), skin_(skin), row_units_(row_units), images_(std::move(images)) {}

  /// For the next build; smoothing lengths that evolve need it.
  void set_support(double support) { support_ = support; }
  double support() const { return support_; }

  /// Builds all lists; `tree` must be fitted to `x`. Throws NumericalError when a bucket's
  /// surroundings exceed 65,535 row units (a numerical collapse).
  void build(const KdTree& tree, const std::vector<Vec3>& x);

  /// Whether some pair may have come within the support unnoticed.
  bool used_up(const std::vector<Vec3>& x) const;

  /// Row image k of a bucket's list: 0 is the particle itself, k > 0 images()[k - 1] of it.
  const std::vector<MirrorImage>& images() const { return images_; }

  const BucketList& operator[](std::size_t bucket) const { return buckets_[bucket]; }
  /// visit(where it is) for every one that particle k of a bucket lists, images included, all at
  /// `x`; also for those that are beyond the support.
  template <class Visit>
  void visit_listed(std::size_t bucket, std::size_t k, const std::vector<Vec3>& x,
                    Visit&& visit) const {
    const BucketList& list = buckets_[bucket];
    for (std::uint32_t e = list.begin[k]; e < list.begin[k + 1]; ++e) {
      const std::size_t place = list.index[e] / row_units_;
      if (place >= list.rows.size()) continue;  // padding
      visit(list.as_seen(place, x[list.rows[place]], images_));
    }
  }
  /// The same for all that any particle of a bucket lists, and its own particles, which come first.
  template <class Visit>
  void visit_around(std::size_t bucket, const std::vector<Vec3>& x, Visit&& visit) const {
    const BucketList& list = buckets_[bucket];
    for (std::size_t place = 0; place < list.rows.size(); ++place)
      visit(list.as_seen(place, x[list.rows[place]], images_));
  }
  std::size_t buckets() const { return buckets_.size(); }
  bool empty() const { return buckets_.empty(); }
  const std::vector<Vec3>& built_at() const { return built_at_; }
  /// Whether a particle had more than a few neighbours at the last build; others are loose.
  bool is_bulk(std::size_t i) const { return slack_[i] < 0; }

 private:
  /// Up to this many listed neighbours a particle counts as loose, else as bulk.
  static constexpr std::size_t loose_neighbours = 8;
  /// How far beyond the support a loose particle looks for unlisted ones, in skins.
  static constexpr double sight = 16;

  struct RigidMotion {
    Vec3 translation, rotation;
  };
  void fit_bulk();
  RigidMotion bulk_motion(const std::vector<Vec3>& x) const;
  double support_, skin_;
  std::size_t row_units_;
  std::vector<MirrorImage> images_;
  std::vector<BucketList> buckets_;
  std::vector<Vec3> built_at_;
  std::vector<float> slack_;  ///< of loose particles: way to go before an unlisted pair meets, m
  Vec3 bulk_centre_;          ///< of the bulk when built
  SymTensor bulk_inverse_;    ///< (sum r^2 1 - r r)^-1 of the bulk about its centre
  double bulk_count_ = 0;
};

}  // namespace eerie::tree
