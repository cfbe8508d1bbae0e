#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "analysis/statistics/ensemble.hpp"
#include "campaign/results/finished_run.hpp"

namespace eerie::results {

/// Runs of one impact with the same settings and several seeds.
template <class Run>
using RunGroup = std::vector<const RunWithResult<Run>*>;

/// Of the runs that have the quantity; `quantity` gives an optional number of a run.
template <class Run, class Quantity>
statistics::Ensemble ensemble_of(const RunGroup<Run>& runs, Quantity&& quantity) {
  std::vector<double> values;
  for (const RunWithResult<Run>* run : runs)
    if (const std::optional<double> value = quantity(*run)) values.push_back(*value);
  return statistics::ensemble(values);
}

/// The part of the runs that `holds` is true of.
template <class Run, class Predicate>
double fraction_of(const RunGroup<Run>& runs, Predicate&& holds) {
  const auto n =
      std::ranges::count_if(runs, [&](const RunWithResult<Run>* run) { return holds(*run); });
  return static_cast<double>(n) / static_cast<double>(runs.size());
}

// Quantities of a finished run, for ensemble_of().

/// Nothing where nothing remained.
inline auto of_largest(std::optional<double> db::Remnant::*member) {
  return [member](const auto& run) -> std::optional<double> {
    return run.remnants.empty() ? std::nullopt : run.remnants.front().*member;
  };
}
inline constexpr auto largest_mass = [](const auto& run) -> std::optional<double> {
  return run.remnants.empty() ? 0 : run.remnants.front().mass_over_total;
};
inline constexpr auto core_seconds_of = [](const auto& run) -> std::optional<double> {
  return run.core_seconds;
};

/// "hit-and-run 1; perfect-merging 5".
std::string count_classes(const std::vector<std::string>& classes);
template <class Run>
std::string classes_of(const RunGroup<Run>& runs) {
  std::vector<std::string> classes;
  for (const RunWithResult<Run>* run : runs) classes.push_back(run->row.result.outcome_class);
  return count_classes(classes);
}

/// Fragments lighter than this, over all mass, do not make a run one with an EER: with few
/// particles they would not be seen at all.
inline constexpr double eer_least_mass = 0.05;

/// Which remnants are asked whether one of them is extremely elongated.
enum class EerAmong {
  largest,
  three_largest,  ///< those of at least eer_least_mass
  any,
};
bool has_eer(const db::Result& result, const std::vector<db::Remnant>& remnants, EerAmong among);

/// P(EER): the part of the runs that have one among those remnants.
template <class Run>
double p_eer(const RunGroup<Run>& runs, EerAmong among) {
  return fraction_of(runs, [among](const RunWithResult<Run>& run) {
    return has_eer(run.row.result, run.remnants, among);
  });
}

// Columns of a table of runs: mass, axes and period of the three largest remnants. Empty fields:
// there is no such remnant, or it does not spin; core_s of a run that lost a machine on its way.

/// Their names, which end with `when`; each behind a comma.
std::string remnant_header(const char* when);
std::string remnant_fields(const std::vector<db::Remnant>& remnants);

/// The last columns of such a table, and what they hold of a run.
inline constexpr const char* run_end_header =
    ",n_eer,dL_over_L,particle_steps,core_s,solver_version,hash\n";
std::string run_end_fields(const db::ResultRow& row, std::optional<double> core_seconds);

}  // namespace eerie::results
