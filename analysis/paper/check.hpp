#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/paper/facts.hpp"
#include "analysis/paper/impact_run.hpp"

namespace eerie::paper {

/// `undecided`: the difference exceeds the tolerance but not the scatter of the seeds, or the
/// scatter is too large to decide. `not_enough`: runs are missing.
enum class Agreement { agrees, disagrees, undecided, not_enough };
inline constexpr std::array<std::string_view, 4> agreement_names = {"agrees", "disagrees",
                                                                    "undecided", "not enough data"};
std::string_view name(Agreement agreement);

/// A number agrees within this fraction of the paper's value.
inline constexpr double check_tolerance = 0.1;
/// A number needs this many runs, and so does an impact that contradicts the paper.
inline constexpr std::size_t check_min_runs = 3;

/// Facts about smaller remnants need this many particles per target. With fewer, the paper's
/// smaller remnant (0.24 target masses) would hardly have 100 particles.
inline constexpr std::int64_t check_smaller_min_particles = 1000;

/// The test of one fact against a database.
struct FactCheck {
  Agreement agreement = Agreement::not_enough;
  std::string found;       ///< "0.266 +- 0.010 (0.252 to 0.279)"
  std::string difference;  ///< "+0.026 (+11 %)"; empty where it agrees or nothing is known
  std::optional<double> paper = {}, value = {};  ///< exist where the fact is a number
  std::optional<double> low = {},
                        high = {};    ///< extremes of the runs, or the 95 % interval of a ridge
  RunSettings settings;               ///< settings of the runs that it uses
  std::size_t runs = 0, impacts = 0;  ///< the runs that it uses, and their points
  std::size_t impacts_wanted = 0;     ///< the points that the paper speaks of
  std::size_t finer = 0;              ///< points that count by runs finer than `settings`
  std::size_t split = 0;              ///< points whose seeds disagree
  std::size_t unsettled = 0;  ///< runs whose remnants will meet again; they count like others
  std::string to_run;         ///< command that would decide it; empty where it is decided
};

/// Tests a fact. On one impact runs of different settings are never mixed. Among the settings that
/// decide the fact, those with the most particles count; where none decide, the finest that has
/// runs. A statement on a grid, its ridge too, takes the settings with the most impacts, and each
/// impact by its finest runs (finest_runs.hpp): impacts that were chosen to be run finer are no
/// map. `database` goes into the command of to_run. `runs` may contain runs that do not concern the
/// fact.
///
/// An impact has a property when at least half of its runs have it. A number agrees when the mean
/// of the runs is within the tolerance, and its standard error is, too. It disagrees when one more
/// run, such as the paper's, would be so far from the mean, beyond the tolerance, with a
/// probability below 2.5 % (Student's t). A statement on a grid agrees when all points have runs
/// and none contradicts it. It disagrees where a point with check_min_runs runs contradicts it.
FactCheck check(const Fact& fact, const std::vector<ImpactRun>& runs, const std::string& database);

}  // namespace eerie::paper
