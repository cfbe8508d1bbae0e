#include "analysis/remnants/binding.hpp"

#include <algorithm>
#include <cmath>

#include "solver/base/constants.hpp"

namespace eerie::remnants {

namespace {

/// Groups under construction, with the potential of each at every clump.
class Grouping {
 public:
  explicit Grouping(std::span<const PointMass> clumps)
      : clumps_(clumps), taken_(clumps.size(), false) {}

  bool taken(std::size_t clump) const { return taken_[clump]; }
  std::size_t size() const { return groups_.size(); }

  void begin(std::size_t clump) {
    groups_.push_back({{}, {}});
    potentials_.emplace_back(clumps_.size(), 0.0);
    add(groups_.size() - 1, clump);
  }

  /// Energy of the clump's motion against the group, per mass of the clump, J/kg.
  double specific_energy(std::size_t group, std::size_t clump) const {
    const PointMass& sum = groups_[group].sum;
    const PointMass& c = clumps_[clump];
    return sum.mass / (sum.mass + c.mass) * norm2(c.v - sum.v) / 2 + potentials_[group][clump];
  }

  void add(std::size_t group, std::size_t clump) {
    const PointMass& c = clumps_[clump];
    BoundGroup& g = groups_[group];
    g.sum = g.members.empty() ? c : together(g.sum, c);
    g.members.push_back(clump);
    taken_[clump] = true;
    std::vector<double>& potential = potentials_[group];
#pragma omp simd
    for (std::size_t k = 0; k < clumps_.size(); ++k) {
      const double r2 = norm2(clumps_[k].x - c.x);
      potential[k] -= r2 > 0 ? newton_G * c.mass / std::sqrt(r2) : 0;
    }
  }

  std::vector<BoundGroup> finish() {
    for (BoundGroup& group : groups_) std::ranges::sort(group.members);
    std::ranges::stable_sort(groups_, std::greater{}, [](const auto& g) { return g.sum.mass; });
    return std::move(groups_);
  }

 private:
  std::span<const PointMass> clumps_;
  std::vector<bool> taken_;
  std::vector<BoundGroup> groups_;
  std::vector<std::vector<double>> potentials_;  ///< [group][clump], without a clump's own
};

/// Free clumps in [first, last) join the group that holds them most tightly among those from
/// `first_group` on, from the most massive clump on, until none joins.
void gather(Grouping& grouping, std::size_t first, std::size_t last, std::size_t first_group) {
  for (bool joined = true; joined;) {
    joined = false;
    for (std::size_t clump = first; clump < last; ++clump) {
      if (grouping.taken(clump)) continue;
      double lowest = 0;
      std::size_t best = grouping.size();
      for (std::size_t group = first_group; group < grouping.size(); ++group) {
        const double energy = grouping.specific_energy(group, clump);
        if (energy < lowest) lowest = energy, best = group;
      }
      if (best == grouping.size()) continue;
      grouping.add(best, clump);
      joined = true;
    }
  }
}

}  // namespace

std::vector<BoundGroup> bound_groups(std::span<const PointMass> clumps, std::size_t cores) {
  Grouping grouping(clumps);
  for (std::size_t core = 0; core < cores; ++core) {
    if (grouping.taken(core)) continue;
    grouping.begin(core);
    gather(grouping, core + 1, cores, grouping.size() - 1);
  }
  gather(grouping, cores, clumps.size(), 0);
  for (std::size_t clump = 0; clump < clumps.size() && grouping.size() < 2; ++clump) {
    if (grouping.taken(clump)) continue;
    grouping.begin(clump);
    gather(grouping, clump + 1, clumps.size(), 0);
  }
  return grouping.finish();
}

}  // namespace eerie::remnants
