#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "analysis/statistics/ensemble.hpp"
#include "campaign/results/finished_run.hpp"

namespace eerie::results {

/// The runs of one impact with the same settings and several seeds.
template <class Run>
using RunGroup = std::vector<const RunWithResult<Run>*>;

/// The statistics of a quantity over the runs that have it. `quantity` returns an optional number
/// for a run.
template <class Run, class Quantity>
statistics::Ensemble ensemble_of(const RunGroup<Run>& runs, Quantity&& quantity) {
  std::vector<double> values;
  for (const RunWithResult<Run>* run : runs)
    if (const std::optional<double> value = quantity(*run)) values.push_back(*value);
  return statistics::ensemble(values);
}

/// The fraction of the runs for which `holds` is true.
template <class Run, class Predicate>
double fraction_of(const RunGroup<Run>& runs, Predicate&& holds) {
  const auto n =
      std::ranges::count_if(runs, [&](const RunWithResult<Run>* run) { return holds(*run); });
  return static_cast<double>(n) / static_cast<double>(runs.size());
}

// These are quantities of a finished run, for ensemble_of().

/// Nothing where no remnant exists.
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

/// The number of runs of each class: "hit-and-run 1; perfect-merging 5".
std::string count_classes(const std::vector<std::string>& classes);
template <class Run>
std::string classes_of(const RunGroup<Run>& runs) {
  std::vector<std::string> classes;
  for (const RunWithResult<Run>* run : runs) classes.push_back(run->row.result.outcome_class);
  return count_classes(classes);
}

/// Elongated fragments lighter than this, in units of all mass, do not count as EERs. Runs with few
/// particles would not resolve them.
inline constexpr double eer_least_mass = 0.05;

/// The set of remnants in which P(EER) looks for an extremely elongated one.
enum class EerAmong {
  largest,
  three_largest,  ///< the three largest of at least eer_least_mass
  any,
};
bool has_eer(const db::Result& result, const std::vector<db::Remnant>& remnants, EerAmong among);

/// P(EER): the fraction of the runs with an EER in that set.
template <class Run>
double p_eer(const RunGroup<Run>& runs, EerAmong among) {
  return fraction_of(runs, [among](const RunWithResult<Run>& run) {
    return has_eer(run.row.result, run.remnants, among);
  });
}

// These are columns of a table of runs: mass, axes and period of the three largest remnants. A
// field is empty where there is no such remnant or where it does not spin. core_s is empty for a
// run that lost a machine on its way.

/// Their names, which end with `when`, with a comma before each.
std::string remnant_header(const char* when);
std::string remnant_fields(const std::vector<db::Remnant>& remnants);

/// The last columns of such a table, and their values for a run.
inline constexpr const char* run_end_header =
    ",n_eer,dL_over_L,particle_steps,core_s,solver_version,hash\n";
std::string run_end_fields(const db::ResultRow& row, std::optional<double> core_seconds);

}  // namespace eerie::results
