#include "analysis/remnants/clumps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "solver/base/error.hpp"

namespace eerie::remnants {

namespace {

using Index = std::uint32_t;
constexpr Index none = ~Index{0};

/// Disjoint sets with path halving; the smaller index is the root.
class Sets {
 public:
  explicit Sets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), Index{0}); }
  Index root(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(Index i, Index j) {
    const auto [low, high] = std::minmax({root(i), root(j)});
    parent_[high] = low;
  }

 private:
  std::vector<Index> parent_;
};

using Cell = std::array<std::int64_t, 3>;
struct CellHash {
  std::size_t operator()(const Cell& c) const {
    std::uint64_t hash = 0;
    for (const std::int64_t k : c)
      hash = (hash ^ static_cast<std::uint64_t>(k)) * 0x9e3779b97f4a7c15ULL, hash ^= hash >> 29;
    return hash;
  }
};

Cell cell_of(const Vec3& x, double size) {
  const Vec3 k{std::floor(x.x / size), std::floor(x.y / size), std::floor(x.z / size)};
  // Beyond 2^53 cells neighbouring cells have no different numbers.
  if (!(std::abs(k.x) < 0x1p53 && std::abs(k.y) < 0x1p53 && std::abs(k.z) < 0x1p53))
    throw NumericalError("particle-lost", -1, -1, "a particle is too far out to find its friends");
  return {static_cast<std::int64_t>(k.x), static_cast<std::int64_t>(k.y),
          static_cast<std::int64_t>(k.z)};
}

/// Half of the 26 cells around one: each pair of cells is met once.
constexpr std::array<Cell, 13> ahead = {{{1, 0, 0},
                                         {-1, 1, 0},
                                         {0, 1, 0},
                                         {1, 1, 0},
                                         {-1, -1, 1},
                                         {0, -1, 1},
                                         {1, -1, 1},
                                         {-1, 0, 1},
                                         {0, 0, 1},
                                         {1, 0, 1},
                                         {-1, 1, 1},
                                         {0, 1, 1},
                                         {1, 1, 1}}};

/// Joins all pairs within reach. Cells are a touch wider than the linking length, so that friends
/// are in the same cell or in one of the 26 around it.
Sets linked(std::span<const Vec3> x, double linking_length) {
  Sets sets(x.size());
  const double width = linking_length * (1 + 1e-6);    // rounding must not hide a friend
  std::unordered_map<Cell, Index, CellHash> first_in;  // first particle of a cell ...
  std::vector<Index> next(x.size(), none);             // ... and the chain of the others
  first_in.reserve(x.size());
  for (Index i = 0; i < x.size(); ++i) {
    const auto [place, is_new] = first_in.try_emplace(cell_of(x[i], width), i);
    if (!is_new) next[i] = std::exchange(place->second, i);
  }
  const double reach2 = linking_length * linking_length;
  const auto join_friends = [&](Index i, Index chain) {
    for (Index j = chain; j != none; j = next[j])
      if (norm2(x[i] - x[j]) <= reach2) sets.join(i, j);
  };
  for (const auto& [cell, first] : first_in) {
    for (Index i = first; i != none; i = next[i]) join_friends(i, next[i]);
    for (const Cell& step : ahead) {
      const auto other = first_in.find({cell[0] + step[0], cell[1] + step[1], cell[2] + step[2]});
      if (other == first_in.end()) continue;
      for (Index i = first; i != none; i = next[i]) join_friends(i, other->second);
    }
  }
  return sets;
}

}  // namespace

std::vector<Clump> friends_of_friends(std::span<const Vec3> x, std::span<const std::uint32_t> id,
                                      double linking_length) {
  Sets sets = linked(x, linking_length);
  std::vector<Index> by_id(x.size());
  std::iota(by_id.begin(), by_id.end(), Index{0});
  std::ranges::sort(by_id, {}, [&](Index i) { return id[i]; });
  // Walking in the order of ids fills clumps in that order, and opens them by their smallest id.
  std::vector<Clump> clumps;
  std::vector<Index> clump_of(x.size(), none);
  for (const Index i : by_id) {
    Index& number = clump_of[sets.root(i)];
    if (number == none) {
      number = static_cast<Index>(clumps.size());
      clumps.emplace_back();
    }
    clumps[number].push_back(i);
  }
  std::ranges::stable_sort(clumps, std::greater{}, &Clump::size);
  return clumps;
}

}  // namespace eerie::remnants
