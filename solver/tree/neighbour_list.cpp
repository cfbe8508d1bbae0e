#include "solver/tree/neighbour_list.hpp"

#include <fmt/format.h>

#include <cmath>

#include "solver/base/error.hpp"
#include "solver/base/simd.hpp"

namespace eerie {

namespace {

/// Surroundings of one bucket as floats relative to its centre, padded to whole vectors.
struct Local {
  std::vector<float> x, y, z;
  void clear() { x.clear(), y.clear(), z.clear(); }
  void push(const Vec3& d) {
    x.push_back(static_cast<float>(d.x));
    y.push_back(static_cast<float>(d.y));
    z.push_back(static_cast<float>(d.z));
  }
};

struct Builder {
  const KdTree& tree;
  const std::vector<Vec3>& x;
  double radius;
  Local local;
  std::vector<std::uint32_t> stack;
  std::vector<std::uint16_t> found;

  /// Ranges of particles that `box` may reach, own bucket excluded, in tree order.
  void collect(const Box& box, std::uint32_t own, BucketList& list) {
    const double r2 = radius * radius;
    stack.assign(1, 0);
    while (!stack.empty()) {
      const KdTree::Node& node = tree.nodes[stack.back()];
      stack.pop_back();
      if (node.begin / bucket_size == own && node.size() <= bucket_size) continue;
      if (distance2(node.box, box) >= r2) continue;
      if (node.is_leaf()) {
        for (std::uint32_t j = node.begin; j < node.end; ++j)
          if (distance2(box, x[j]) < r2) list.rows.push_back(j);
      } else {
        stack.push_back(node.right);
        stack.push_back(node.left);
      }
    }
  }

  void build(std::uint32_t bucket, BucketList& list) {
    const auto first = static_cast<std::uint32_t>(bucket * bucket_size);
    const auto last = static_cast<std::uint32_t>(std::min<std::size_t>(first + bucket_size, x.size()));
    Box box;
    for (std::uint32_t i = first; i < last; ++i) box.include(x[i]);
    list.rows.clear();
    list.index.clear();
    for (std::uint32_t i = first; i < last; ++i) list.rows.push_back(i);
    collect(box, bucket, list);
    if (list.rows.size() >= 65535)
      throw NumericalError("collapse", -1, static_cast<long>(first),
                           fmt::format("{} particles crowd around one bucket of {}", list.rows.size(),
                                       bucket_size));
    const Vec3 centre = box.centre();
    local.clear();
    for (std::uint32_t j : list.rows) local.push(x[j] - centre);
    while (local.x.size() % lanes<float> != 0) local.push({1e9, 1e9, 1e9});
    for (std::uint32_t k = 0; k < last - first; ++k) {
      list.begin[k] = static_cast<std::uint32_t>(list.index.size());
      append_neighbours(k, list);
    }
    for (std::size_t k = last - first; k <= bucket_size; ++k)
      list.begin[k] = static_cast<std::uint32_t>(list.index.size());
  }

  void append_neighbours(std::uint32_t k, BucketList& list) {
    using P = Pack<float>;
    // Rounding of float positions must not lose a pair: widen the radius by a part in 1e5.
    const auto r2 = static_cast<float>(radius * radius * (1 + 2e-5));
    const float xk = local.x[k], yk = local.y[k], zk = local.z[k];
    found.resize(local.x.size() + lanes<float>);
    std::uint16_t* end = found.data();
    for (std::size_t l = 0; l < local.x.size(); l += lanes<float>) {
      P dx, dy, dz;
      std::memcpy(&dx, &local.x[l], sizeof dx);
      std::memcpy(&dy, &local.y[l], sizeof dy);
      std::memcpy(&dz, &local.z[l], sizeof dz);
      dx -= xk, dy -= yk, dz -= zk;
      P distance2 = dx * dx + dy * dy + dz * dz;
      if (l == k / lanes<float> * lanes<float>) distance2[k - l] = 2 * r2;  // not itself
      end = append_less(distance2, r2, static_cast<std::uint16_t>(l), end);
    }
    while (static_cast<std::size_t>(end - found.data()) % NeighbourList::padding != 0)
      *end++ = static_cast<std::uint16_t>(list.rows.size());
    list.index.insert(list.index.end(), found.data(), end);
  }
};

}  // namespace

void NeighbourList::build(const KdTree& tree, const std::vector<Vec3>& x) {
  buckets_.resize(bucket_count(x.size()));
  built_at_ = x;
  std::string failure;
#pragma omp parallel
  {
    Builder builder{tree, x, support_ + skin_, {}, {}, {}};
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
}

bool NeighbourList::used_up(const std::vector<Vec3>& x) const {
  double largest = 0;
#pragma omp parallel for reduction(max : largest) schedule(static)
  for (std::size_t i = 0; i < x.size(); ++i)
    largest = std::max(largest, norm2(x[i] - built_at_[i]));
  return 2 * std::sqrt(largest) >= skin_;
}

}  // namespace eerie
