#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "solver/base/tensor.hpp"
#include "solver/tree/images.hpp"
#include "solver/tree/kd_tree.hpp"

namespace eerie::tree {

/// The neighbours of one bucket. `rows` is the union of all particles near it, its own first. Each
/// particle of the bucket has a list of places in that union, multiplied by the row units of the
/// NeighbourList.
/// Lists are padded to a multiple of `padding` with the length of the union. That is the place of a
/// dummy row, which contributes nothing.
struct BucketList {
  std::vector<std::uint32_t> rows;  ///< particles, by memory index
  /// With walls: the image that each row is, see NeighbourList::images().
  std::vector<std::uint8_t> images;
  std::vector<std::uint16_t> index;                    ///< all lists one after another
  std::array<std::uint32_t, bucket_size + 1> begin{};  ///< list k: index[begin[k]..begin[k+1])

  /// The position of row `place`, whose particle is at `x`: that position or its mirror image.
  Vec3 as_seen(std::size_t place, const Vec3& x, const std::vector<MirrorImage>& mirrors) const {
    const std::size_t image = images.empty() ? 0 : images[place];
    return image == 0 ? x : mirrors[image - 1](x);
  }
};

/// Neighbour lists of all buckets, with a search radius beyond the support (a Verlet skin). They
/// hold every pair closer than the support until an unlisted pair has approached by the skin. For
/// most particles this is measured relative to the rigid motion of the bulk, so that a settled body
/// that flies and spins needs no new lists. For loose particles, which have few neighbours, it is
/// measured by the distance to the nearest unlisted one. Lists are a pure function of memory order
/// and positions, for any number of threads. With walls, mirror images of particles are neighbours
/// too, and plain displacements are measured.
class NeighbourList {
 public:
  static constexpr std::size_t padding = 16;

  /// `support` is the support radius of the kernel, m, and `skin` the extra radius, m. Entries of
  /// the lists are multiplied by `row_units`, so that they serve as offsets of rows.
  NeighbourList(double support, double skin, std::vector<MirrorImage> images = {},
                std::size_t row_units = 1)
      : support_(support), skin_(skin), row_units_(row_units), images_(std::move(images)) {}

  /// Sets the support radius of the next build, m. Evolving smoothing lengths need it.
  void set_support(double support) { support_ = support; }
  double support() const { return support_; }

  /// Builds all lists. `tree` must be fitted to `x`. Throws NumericalError where the surroundings
  /// of a bucket exceed 65,535 row units, which means a numerical collapse.
  void build(const KdTree& tree, const std::vector<Vec3>& x);

  /// Whether an unlisted pair may have come within the support.
  bool used_up(const std::vector<Vec3>& x) const;

  /// The images that rows of a bucket refer to: 0 is the particle itself, k > 0 is images()[k - 1].
  const std::vector<MirrorImage>& images() const { return images_; }

  const BucketList& operator[](std::size_t bucket) const { return buckets_[bucket]; }
  /// Calls visit(position, index) for every neighbour that particle k of a bucket lists, images and
  /// those beyond the support included. Particles are at `x`.
  template <class Visit>
  void visit_listed(std::size_t bucket, std::size_t k, const std::vector<Vec3>& x,
                    Visit&& visit) const {
    const BucketList& list = buckets_[bucket];
    for (std::uint32_t e = list.begin[k]; e < list.begin[k + 1]; ++e) {
      const std::size_t place = list.index[e] / row_units_;
      if (place >= list.rows.size()) continue;  // padding
      visit(list.as_seen(place, x[list.rows[place]], images_), list.rows[place]);
    }
  }
  std::size_t buckets() const { return buckets_.size(); }
  bool empty() const { return buckets_.empty(); }
  const std::vector<Vec3>& built_at() const { return built_at_; }
  /// Whether a particle belonged to the bulk at the last build, that is, had more than a few
  /// neighbours. All others are loose.
  bool is_bulk(std::size_t i) const { return slack_[i] < 0; }

 private:
  /// A particle with at most so many listed neighbours is loose; others belong to the bulk.
  static constexpr std::size_t loose_neighbours = 8;
  /// The distance beyond the support to which a loose particle looks for unlisted ones, in skins.
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
  /// Of loose particles: distance left before an unlisted pair meets, m.
  std::vector<float> slack_;
  Vec3 bulk_centre_;        ///< centre of the bulk at the last build
  SymTensor bulk_inverse_;  ///< (sum r^2 1 - r r)^-1 of the bulk about its centre
  double bulk_count_ = 0;
};

}  // namespace eerie::tree
