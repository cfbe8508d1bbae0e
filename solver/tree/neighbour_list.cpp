#include "solver/tree/neighbour_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/base/error.hpp"
#include "solver/base/simd/search.hpp"
#include "solver/tree/places.hpp"

namespace eerie::tree {

namespace {

struct Builder {
  const KdTree& tree;
  const std::vector<Vec3>& x;
  std::size_t loose_neighbours;
  double support, radius, far_radius;
  const std::vector<MirrorImage>& images;
  std::size_t row_units;
  std::vector<float>& slack;
  Places local;  ///< relative to the centre of the bucket
  std::vector<std::uint32_t> stack;
  std::vector<std::uint32_t> rows;
  /// What a list says for each row; the lists, in room for the longest; how far they go.
  std::vector<std::uint16_t> ids, index;
  std::size_t listed = 0;

  /// Particles that `box` may reach, bucket `own` excluded, in tree order.
  void collect(const Box& box, std::uint32_t own) {
    const double r2 = radius * radius;
    stack.assign(1, 0);
    while (!stack.empty()) {
      const KdTree::Node& node = tree.nodes[stack.back()];
      stack.pop_back();
      if (node.begin / bucket_size == own && node.size() <= bucket_size) continue;
      if (distance2(node.box, box) >= r2) continue;
      if (node.is_leaf()) {
        const std::size_t n = rows.size();
        rows.resize(n + KdTree::leaf_size + lanes<double>);
        std::uint32_t* end = rows.data() + n;
        for (std::uint32_t j = node.begin; j < node.end; j += lanes<double>)
          end = append_less(distances2(box, j, node.end), r2, j, end);
        rows.resize(static_cast<std::size_t>(end - rows.data()));
      } else {
        stack.push_back(node.right);
        stack.push_back(node.left);
      }
    }
  }

  /// The squared distances of particles j, j + 1... before `last` from a box; infinite beyond.
  Pack<double> distances2(const Box& box, std::uint32_t j, std::uint32_t last) const {
    static_assert(sizeof(Vec3) == 3 * sizeof(double));  // side by side, without gaps
    const std::size_t count = std::min<std::size_t>(last - j, lanes<double>);
    const auto [px, py, pz] = load_vectors(&x[j].x, count);
    const Pack<double> dx = positive_part(box.lo.x - px) + positive_part(px - box.hi.x),
                       dy = positive_part(box.lo.y - py) + positive_part(py - box.hi.y),
                       dz = positive_part(box.lo.z - pz) + positive_part(pz - box.hi.z);
    Pack<double> d2 = dx * dx + dy * dy + dz * dz;
    for (std::size_t l = count; l < lanes<double>; ++l) d2[l] = 1e300;
    return d2;
  }

  /// Mirror images that `box` may reach, of any bucket: an image of `box` reaches the particle.
  void collect_images(const Box& box, BucketList& list) {
    constexpr std::uint32_t none_left_out = 0xffffffff;
    list.images.assign(rows.size(), 0);
    for (std::size_t k = 0; k < images.size(); ++k) {
      collect(images[k](box), none_left_out);
      list.images.resize(rows.size(), static_cast<std::uint8_t>(k + 1));
    }
  }

  void build(std::uint32_t bucket, BucketList& list) {
    const auto first = static_cast<std::uint32_t>(bucket * bucket_size);
    const auto last =
        static_cast<std::uint32_t>(std::min<std::size_t>(first + bucket_size, x.size()));
    Box box;
    for (std::uint32_t i = first; i < last; ++i) box.include(x[i]);
    rows.clear();
    list.images.clear();
    for (std::uint32_t i = first; i < last; ++i) rows.push_back(i);
    collect(box, bucket);
    if (!images.empty()) collect_images(box, list);
    if (rows.size() * row_units > 65535)
      throw NumericalError(
          "collapse", -1, static_cast<long>(first),
          fmt::format("{} particles crowd around one bucket of {}", rows.size(), bucket_size));
    const Vec3 centre = box.centre();
    local.fill(rows.size(),
               [&](std::size_t k) { return list.as_seen(k, x[rows[k]], images) - centre; });
    while (ids.size() < local.x.size())
      ids.push_back(static_cast<std::uint16_t>(ids.size() * row_units));
    listed = 0;
    for (std::uint32_t k = 0; k < last - first; ++k) {
      list.begin[k] = static_cast<std::uint32_t>(listed);
      const std::size_t neighbours = append_neighbours(k);
      // Bulk particles need no slack of their own: their nearest unlisted one is a skin away. That
      // of loose ones is never below 0, which would make them bulk: without a skin it is rounding.
      slack[first + k] =
          neighbours > loose_neighbours || !images.empty()
              ? -1.0f
              : std::max(0.f, static_cast<float>(unlisted_distance(first + k) - support));
    }
    for (std::size_t k = last - first; k <= bucket_size; ++k)
      list.begin[k] = static_cast<std::uint32_t>(listed);
    // Copied at their length: grown in place they would hold up to twice the memory.
    list.rows.assign(rows.begin(), rows.end());
    list.index.assign(index.data(), index.data() + listed);
  }

  std::size_t append_neighbours(std::uint32_t k) {
    // Rounding of float positions must not lose a pair: widen the radius by a part in 1e5.
    const auto r2 = static_cast<float>(radius * radius * (1 + 2e-5));
    const float xk = local.x[k], yk = local.y[k], zk = local.z[k];
    local.x[k] = 1e9f;  // out of its own way
    const std::size_t most = listed + local.x.size() + NeighbourList::padding;
    if (index.size() < most) index.resize(2 * most);
    std::uint16_t* const begin = index.data() + listed;
    std::uint16_t* end = begin;
    local.visit_packs_near(xk, yk, zk, r2, [&](std::size_t l) {
      end = append_less(local.distance2(l, xk, yk, zk), r2, ids.data() + l, end);
    });
    local.x[k] = xk;
    const auto neighbours = static_cast<std::size_t>(end - begin);
    while (static_cast<std::size_t>(end - begin) % NeighbourList::padding != 0)
      *end++ = static_cast<std::uint16_t>(rows.size() * row_units);
    listed += static_cast<std::size_t>(end - begin);
    return neighbours;
  }

  /// Distance of particle i to the nearest one beyond the list radius, at most far_radius.
  float unlisted_distance(std::uint32_t i) {
    double nearest2 = far_radius * far_radius;
    stack.assign(1, 0);
    while (!stack.empty()) {
      const KdTree::Node& node = tree.nodes[stack.back()];
      stack.pop_back();
      if (distance2(node.box, x[i]) >= nearest2) continue;
      if (node.is_leaf()) {
        for (std::uint32_t j = node.begin; j < node.end; ++j)
          if (const double d2 = norm2(x[j] - x[i]); d2 >= radius * radius)
            nearest2 = std::min(nearest2, d2);
      } else {
        stack.push_back(node.right);
        stack.push_back(node.left);
      }
    }
    return static_cast<float>(std::sqrt(nearest2) * (1 - 1e-6));
  }
};

}  // namespace

void NeighbourList::build(const KdTree& tree, const std::vector<Vec3>& x) {
  buckets_.resize(bucket_count(x.size()));
  built_at_ = x;
  slack_.resize(x.size());
  std::string failure;
#pragma omp parallel
  {
    Builder builder{tree,
                    x,
                    loose_neighbours,
                    support_,
                    support_ + skin_,
                    support_ + sight * skin_,
                    images_,
                    row_units_,
                    slack_,
                    {},
                    {},
                    {},
                    {},
                    {},
                    0};
#pragma omp for schedule(dynamic, 4)
    for (std::size_t b = 0; b < buckets_.size(); ++b) {
      try {
        builder.build(static_cast<std::uint32_t>(b), buckets_[b]);
      } catch (const NumericalError& error) {
#pragma omp critical
        failure = error.what();
      }
    }
  }
  if (!failure.empty()) throw NumericalError("collapse", -1, -1, failure);
  fit_bulk();
}

void NeighbourList::fit_bulk() {
  bulk_centre_ = {};
  bulk_count_ = 0;
  for (std::size_t i = 0; i < built_at_.size(); ++i)
    if (is_bulk(i)) bulk_centre_ += built_at_[i], ++bulk_count_;
  if (bulk_count_ > 0) bulk_centre_ *= 1 / bulk_count_;
  SymTensor sum;
  for (std::size_t i = 0; i < built_at_.size(); ++i) {
    if (!is_bulk(i)) continue;
    const Vec3 r = built_at_[i] - bulk_centre_;
    const double r2 = norm2(r);
    sum += {r2 - r.x * r.x, r2 - r.y * r.y, r2 - r.z * r.z, -r.x * r.y, -r.x * r.z, -r.y * r.z};
  }
  const double det = determinant(sum);
  bulk_inverse_ = det > 0 ? inverse(sum, det) : SymTensor{};
}

/// Least-squares translation and (small) rotation of the bulk since the lists were built. Sums
/// run over buckets in order, so every number of threads finds the same.
NeighbourList::RigidMotion NeighbourList::bulk_motion(const std::vector<Vec3>& x) const {
  std::vector<RigidMotion> parts(buckets_.size());
#pragma omp parallel for schedule(static)
  for (std::size_t b = 0; b < buckets_.size(); ++b) {
    RigidMotion part;
    for (std::size_t i = b * bucket_size; i < std::min((b + 1) * bucket_size, x.size()); ++i) {
      if (!is_bulk(i)) continue;
      const Vec3 moved = x[i] - built_at_[i];
      part.translation += moved;
      part.rotation += cross(built_at_[i] - bulk_centre_, moved);
    }
    parts[b] = part;
  }
  RigidMotion sum;
  for (const RigidMotion& part : parts)
    sum.translation += part.translation, sum.rotation += part.rotation;
  return {sum.translation / std::max(1.0, bulk_count_), to_matrix(bulk_inverse_) * sum.rotation};
}

/// Two particles that do not list each other were at least support + skin apart. Moving both by
/// x -> x + D + W x (x - centre) never brings them closer, so what counts is how far each strays
/// from that motion. For a loose particle, far out where W x r is large, D alone is taken out.
bool NeighbourList::used_up(const std::vector<Vec3>& x) const {
  // Walls stand still, so with them there is no motion to take out.
  const RigidMotion bulk = images_.empty() ? bulk_motion(x) : RigidMotion{};
  double strayed = 0, bulk_moved = 0;
#pragma omp parallel for reduction(max : strayed, bulk_moved) schedule(static)
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!is_bulk(i)) continue;
    const Vec3 moved = x[i] - built_at_[i] - bulk.translation;
    strayed = std::max(strayed, norm2(moved - cross(bulk.rotation, built_at_[i] - bulk_centre_)));
    bulk_moved = std::max(bulk_moved, norm2(moved));
  }
  if (2 * std::sqrt(strayed) >= skin_) return true;
  bulk_moved = std::sqrt(bulk_moved);
  bool used = false;
#pragma omp parallel for reduction(|| : used) schedule(static)
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (is_bulk(i)) continue;
    const double moved = norm(x[i] - built_at_[i] - bulk.translation);
    used = used || moved + std::max(moved, bulk_moved) >= static_cast<double>(slack_[i]);
  }
  return used;
}

}  // namespace eerie::tree
