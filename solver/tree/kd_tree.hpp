#pragma once

#include <cstdint>
#include <vector>

#include "solver/base/box.hpp"
#include "solver/base/vec3.hpp"

namespace eerie::tree {

/// The number of particles of one bucket. Memory order, OpenMP work, neighbour lists and targets of
/// gravity all come in buckets. All buckets but the last are full.
inline constexpr std::size_t bucket_size = 64;

inline std::size_t bucket_count(std::size_t particles) {
  return (particles + bucket_size - 1) / bucket_size;
}

/// A balanced binary tree over the memory order. Its topology depends on the number of particles
/// alone: it halves ranges at multiples of the bucket size, and then inside buckets down to
/// `leaf_size`. So after a restart the same memory order gives the same tree.
struct KdTree {
  static constexpr std::uint32_t leaf_size = 8;
  static constexpr std::uint32_t none = 0xffffffff;

  struct Node {
    std::uint32_t begin, end;   ///< range of particles
    std::uint32_t left, right;  ///< children, or none
    Box box;                    ///< around the particles at the last fit
    bool is_leaf() const { return left == none; }
    std::uint32_t size() const { return end - begin; }
  };
  std::vector<Node> nodes;  ///< the root first; children after their parent

  explicit KdTree(std::size_t particles);

  /// Fits the box of every node to the present positions of the particles.
  void fit(const std::vector<Vec3>& x);
};

/// The permutation (new index -> old index) that sorts particles into kd order: each range of the
/// tree is split along the longest side of its box. It is a pure function of positions and ids.
std::vector<std::uint32_t> kd_order(const std::vector<Vec3>& x,
                                    const std::vector<std::uint32_t>& id);

}  // namespace eerie::tree
