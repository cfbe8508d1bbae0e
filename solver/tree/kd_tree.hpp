#pragma once

#include <cstdint>
#include <vector>

#include "solver/base/box.hpp"
#include "solver/base/vec3.hpp"

namespace eerie::tree {

/// Particles of one bucket: the unit of memory order, of OpenMP work, of neighbour lists and
/// of gravity targets. All but the last bucket are full.
inline constexpr std::size_t bucket_size = 64;

inline std::size_t bucket_count(std::size_t particles) {
  return (particles + bucket_size - 1) / bucket_size;
}

/// Balanced binary tree over the memory order. Its topology depends on the number of particles
/// only (ranges are halved at multiples of the bucket size, then inside buckets down to
/// `leaf_size`), so after a restart the same memory order gives the same tree.
struct KdTree {
  static constexpr std::uint32_t leaf_size = 8;
  static constexpr std::uint32_t none = 0xffffffff;

  struct Node {
    std::uint32_t begin, end;   ///< range of particles
    std::uint32_t left, right;  ///< children, or none
    Box box;                    ///< of the particles, as of the last fit
    bool is_leaf() const { return left == none; }
    std::uint32_t size() const { return end - begin; }
  };
  std::vector<Node> nodes;  ///< the root first; children after their parent

  explicit KdTree(std::size_t particles);

  /// Fits every node's box to where the particles are now.
  void fit(const std::vector<Vec3>& x);
};

/// Permutation (new index -> old index) that sorts particles into kd order: each range of the
/// tree is split along the longest side of its box. A pure function of positions and ids.
std::vector<std::uint32_t> kd_order(const std::vector<Vec3>& x,
                                    const std::vector<std::uint32_t>& id);

}  // namespace eerie::tree
