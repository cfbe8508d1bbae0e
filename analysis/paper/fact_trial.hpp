#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analysis/paper/check.hpp"
#include "analysis/paper/check_runs.hpp"

namespace eerie::paper {

/// The number of seeds to ask for first.
inline constexpr std::size_t first_seeds = 6;

/// Tests one fact against runs with the same settings.
class Trial {
 public:
  Trial(const Fact& fact, const std::vector<ImpactRun>& runs, const RunSettings& settings,
        const std::string& database);
  FactCheck finding();
  void operator()(const NumberIs& claim);
  void operator()(const AlmostMerges&);
  void operator()(const ShapeLasts& claim);
  void operator()(const SmallerIsEer&);
  void operator()(const StiffnessIsIdle& claim);
  void operator()(const RidgeIsAt& claim);
  void operator()(const EersOnlyIn& claim);
  void operator()(const NoEer&);
  void operator()(const EersExactlyAt& claim);
  void operator()(const EersAreMerged&);
  void operator()(const SmallerEersOnlyIn& claim);
  void operator()(const MostlyOfClass& claim);
  void operator()(const AllClassesOccur&);

 private:
  void refuse_as_too_coarse();
  bool only_missing() const;
  const CheckCell& only() const;
  void rest_on(const std::vector<CheckCell>& cells);
  std::size_t count_cells(const CheckCell::Condition& condition) const;
  void ask_for_seeds(const CheckCell& cell);
  /// The commands for the fact's sweeps with a seed that no run has yet.
  std::string one_seed_more() const;
  /// Tests a statement on one impact, which holds where at least half of its runs have the
  /// property.
  void most_runs(const std::vector<const ImpactRun*>& runs, const CheckCell::Condition& condition,
                 const char* verb);
  /// Tests a statement on a grid by the points that contradict it and those that have no run yet.
  /// `matter` names the property on which seeds may disagree.
  void by_contradictions(const std::function<bool(const CheckCell&)>& contradicts,
                         const CheckCell::Condition& matter);

  const Fact& fact_;
  const std::vector<ImpactRun>& runs_;
  RunSettings settings_;
  const std::string& database_;
  std::vector<CheckCell> cells_;
  std::vector<const ImpactRun*> stiff_;
  FactCheck f_;
};

}  // namespace eerie::paper
