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

/// undecided: as far from the paper as the tolerance forbids, but not further than seeds differ
/// among themselves, or too scattered to say; not_enough: runs are missing.
enum class Agreement { agrees, disagrees, undecided, not_enough };
inline constexpr std::array<std::string_view, 4> agreement_names = {"agrees", "disagrees",
                                                                    "undecided", "not enough data"};
std::string_view name(Agreement agreement);

/// A number agrees within this part of the paper's value, whatever it is a number of.
inline constexpr double check_tolerance = 0.1;
/// Numbers need this many runs, and so does an impact that contradicts the paper.
inline constexpr std::size_t check_min_runs = 3;

/// Facts about smaller remnants need so many particles per target, or the paper's own (0.24 target
/// masses) would hardly be a remnant of 100 particles.
inline constexpr std::int64_t check_smaller_min_particles = 1000;

/// What a database says about a fact.
struct FactCheck {
  Agreement agreement = Agreement::not_enough;
  std::string found;       ///< "0.266 +- 0.010 (0.252 to 0.279)"
  std::string difference;  ///< "+0.026 (+11 %)"; empty where it agrees or nothing is known
  std::optional<double> paper = {}, value = {};  ///< where the fact is a number
  std::optional<double> low = {}, high = {};     ///< of the runs, or the 95 % interval of a ridge
  RunSettings settings;                          ///< of the runs that it rests on
  std::size_t runs = 0, impacts = 0;             ///< how many, at how many points ...
  std::size_t impacts_wanted = 0;                ///< ... of those that the paper means
  std::size_t split = 0;                         ///< points whose seeds do not agree on the matter
  std::size_t unsettled = 0;  ///< runs whose remnants will meet again; they count as they stand
  std::string to_run;         ///< what would decide it; empty where decided
};

/// Tests a fact. Runs of different settings are never mixed: of those that decide the fact, the
/// ones with most particles count; where none do, those with most impacts. `database` goes into the
/// command of to_run. The runs may be of anything; those that do not concern the fact are left out.
///
/// An impact "is" what at least half of its runs are. A number agrees when the mean of the runs is
/// within the tolerance and known to it (standard error); it disagrees when one more run, as the
/// paper's was, would be so far out with a probability below 2.5 % (Student's t), tolerance
/// granted. A statement on a grid agrees when no point of the grid contradicts it and all have
/// runs; it disagrees where a point with check_min_runs runs contradicts it.
FactCheck check(const Fact& fact, const std::vector<ImpactRun>& runs, const std::string& database);

}  // namespace eerie::paper
